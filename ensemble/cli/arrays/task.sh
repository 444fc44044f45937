floes=${FLOES:-@PROGRAM@}
# shellcheck disable=SC2034  # not every system asks
cancelled=''
child=''

# compute PART [OPTION…]: computes the part, or resumes it where it ended, and returns its status. A request to stop goes
# on to it: it keeps what is done and ends with 85. Some systems signal every process of a task, and SIGUSR2 would kill.
compute() {
    local status=0 part=$1
    shift
    (trap '' USR2 && exec "$floes" run @CONFIG@ --part "$part/@PARTS@" -o @STEM@".part$part.h5" \
        @OPTIONS@ "$@" --resume) &
    child=$!
    trap 'trap : TERM; kill -USR1 "$child" 2> /dev/null' USR1 USR2
    trap 'cancelled=yes; kill -USR1 "$child" 2> /dev/null' TERM INT HUP
    while kill -0 "$child" 2> /dev/null; do wait "$child" || true; done  # a signal ends a wait, not the child
    wait "$child" || status=$?
    trap : USR1 USR2
    trap 'cancelled=yes' TERM INT HUP
    echo "floes: part $part of @PARTS@ ended with $status" >&2
    return "$status"
}
