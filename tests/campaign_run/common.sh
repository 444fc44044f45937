# Sourced by the tests of whole campaigns: bash TEST.sh FLOES MPIEXEC. Each works in a folder of its own and fails on
# the first thing that is not as it should be.
set -euo pipefail
FLOES=$1
MPIEXEC=$2
# Whatever the machine and the user: "${MPIRUN[@]}" -n 2 program …
MPIRUN=("$MPIEXEC")
if [[ $("$MPIEXEC" --version 2>&1) == *"Open MPI"* || $("$MPIEXEC" --version 2>&1) == *OpenRTE* ]]; then
    MPIRUN+=(--allow-run-as-root --oversubscribe --bind-to none)
fi
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

unset FLOES_LAUNCHER

# shellcheck source=SCRIPTDIR/../support/channel.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/channel.sh"
FOLDER=$(mktemp -d)
trap 'rm -rf "$FOLDER"' EXIT
cd "$FOLDER"

channel 4 4 24.0 > campaign.toml

fail() {
    echo "FAILED: $*" >&2
    for log in *.log; do
        echo "--- $log" >&2
        cat "$log" >&2
    done
    exit 1
}

# expect STATUS NAME COMMAND…: runs it with its output in NAME.log, and fails unless it ends with that status.
expect() {
    local wanted=$1 name=$2 status=0
    shift 2
    "$@" > "$name.log" 2>&1 || status=$?
    [ "$status" -eq "$wanted" ] || fail "'$*' ended with $status instead of $wanted"
}

# said NAME TEXT: fails unless the output of NAME has the text.
said() {
    grep -qF -- "$2" "$1.log" || fail "$1 did not say '$2'"
}

# wait_for_a_member FILE.journal: until the journal has a member (or the campaign is over); a header takes less.
wait_for_a_member() {
    for _ in $(seq 3000); do
        [ ! -e "${1%.journal}.h5" ] || [ -e "$1" ] || return 0
        if [ "$(stat -c %s "$1" 2> /dev/null || echo 0)" -gt 30000 ]; then return; fi
        sleep 0.02
    done
    fail "no member within a minute"
}
