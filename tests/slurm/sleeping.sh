# Sourced where floes falls asleep: it and the processes that compute its members, which else would finish them meanwhile.

put_to_sleep() {
    kill -STOP "$1"  # first, so that it starts no other
    pkill -STOP -P "$1" || true
}

# Asks it to stop, and only then wakes those who compute.
ask_and_wake() {
    kill -USR1 "$1"
    kill -CONT "$1"
    pkill -CONT -P "$1" || true
}
