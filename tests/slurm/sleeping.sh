# Sourced where floes falls asleep: it, the process from which it starts members, and those that compute them, which else
# would finish them meanwhile.

# put_to_sleep FLOES: parents first, so that they start no others.
put_to_sleep() {
    local child
    kill -STOP "$1" 2> /dev/null || return 0  # it has just ended
    for child in $(pgrep -P "$1"); do put_to_sleep "$child"; done
}

# wake FLOES: parents first, so that what they ask of a member waits for it when it wakes.
wake() {
    local child
    kill -CONT "$1" 2> /dev/null || return 0
    sleep 0.5
    for child in $(pgrep -P "$1"); do wake "$child"; done
}

ask_and_wake() {
    kill -USR1 "$1"
    wake "$1"
}
