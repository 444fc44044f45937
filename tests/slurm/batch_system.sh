# Sourced by the tests of batch systems: bash TEST.sh FLOES PROJECT. What they share, whichever system they start: a folder
# of their own, and the end of all that was started in it.
set -euo pipefail
export FLOES=$1       # what the scripts run
export FLOES_HOME=$2  # where the scripts are
PROGRAM=$FLOES
TEST=$$

FOLDER=$(mktemp -d)   # short: the path of a socket has at most 107 characters
CLUSTER=$FOLDER/cluster
mkdir -p "$CLUSTER"/{run,state,log}
chmod 755 "$FOLDER"
# What all processes of this test's system have in their environment, and no others.
MARK=$MARK_VARIABLE=$CLUSTER/$MARK_FILE
export "${MARK?}"

tell_system() { :; }  # what the system knows of its jobs

fail() {
    echo "FAILED: $*" >&2
    tail -n +1 "$FOLDER"/*.log >&2 || true
    tell_system >&2 2>&1 || true
    tail -n 20 "$CLUSTER"/log/*.log >&2 || true
    exit 1
}

# The processes of the system: its daemons, its jobs and all they started.
cluster_pids() {
    env -u "$MARK_VARIABLE" grep -lzsxF "$MARK" /proc/[0-9]*/environ | cut -d/ -f3
}

end_cluster() {
    local pids
    for _ in 1 2 3 4 5; do  # until nothing is left that could start another
        mapfile -t pids < <(cluster_pids)
        [ ${#pids[@]} -gt 0 ] || break
        kill -CONT "${pids[@]}" 2> /dev/null || true
        kill -KILL "${pids[@]}" 2> /dev/null || true
        sleep 0.2
    done
    rm -rf "$FOLDER"
}
trap end_cluster EXIT
trap 'exit 1' INT TERM HUP

# The trap does not run when the test is killed. This one outlives it and is nobody's child, so that whoever kills a
# tree of processes does not find it.
watch_over_test() {
    while kill -0 "$TEST" 2> /dev/null; do sleep 1; done
    [ ! -e "$FOLDER" ] || end_cluster
}
(trap - EXIT; trap '' INT TERM HUP; watch_over_test > /dev/null 2>&1 < /dev/null &)

# until_true SECONDS COMMAND…: fails unless the command succeeds within that time.
until_true() {
    local end=$((SECONDS + $1))
    shift
    until "$@"; do
        [ $SECONDS -lt $end ] || return 1
        sleep 0.1
    done
}

# free_ports USE…: a port for each. A process holds them by name until the system ends, so that no other test gets them
# before they are used; they lie below those that the kernel gives to whoever asks for any.
free_ports() {
    /usr/bin/python3 - "$TEST" "$@" <<'PYTHON'
import os, random, socket, sys, time
test, *uses = sys.argv[1:]
held = {}
while len(held) < len(uses):
    port = random.randrange(20000, 32768)
    with socket.socket() as tried:
        name = socket.socket(socket.AF_UNIX)
        try:
            name.bind(f"\0floes-test-port-{port}")
            tried.bind(("127.0.0.1", port))
        except OSError:
            continue
    held[port] = name
print(*held, flush=True)
if os.fork() == 0:
    os.setsid()
    for stream in range(3):
        os.close(stream)
    while os.path.exists(f"/proc/{test}"):
        time.sleep(1)
PYTHON
}

# as_daemon NAME COMMAND…: in a session of its own, its output in the cluster's logs.
as_daemon() {
    local name=$1
    shift
    setsid "$@" > "$CLUSTER/log/$name.out" 2>&1 < /dev/null &
    disown  # no word from bash when it is killed
}

source "$(dirname "${BASH_SOURCE[0]}")/small_campaign.sh"
