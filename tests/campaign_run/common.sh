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

FOLDER=$(mktemp -d)
trap 'rm -rf "$FOLDER"' EXIT
cd "$FOLDER"

# campaign.toml: 2 cases x 4 arrangements of four floes, some tenths of a second each.
cat > campaign.toml <<'TOML'
[campaign]
seed = 1
arrangements = 4

[field]
floes = 4
concentration_percent = 40.0
begin_m = 2.0
half_width_m = 1.25

[structure]
profile_m = [[-0.443, 0.43], [0.0, 0.614], [0.122, 0.736]]
start_m = 1.38
speed_m_s = 0.03

[analysis]
steady_start_s = 2.0
window_s = 24.0

[[case]]
name = "E30"
elastic_modulus_MPa = 30.0

[[case]]
name = "E200"
elastic_modulus_MPa = 200.0
TOML

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

# same A.h5 B.h5: fails unless both files have the same values outside /provenance.
same() {
    h5diff --exclude-path /provenance "$1" "$2" > difference.log 2>&1 || fail "$1 and $2 differ"
}

# wait_for_a_member FILE.journal: until the journal has a member (or the campaign is over); a header takes less.
wait_for_a_member() {
    for _ in $(seq 3000); do
        if [ "$(stat -c %s "$1" 2> /dev/null || echo 0)" -gt 30000 ]; then return; fi
        sleep 0.02
    done
    fail "no member within a minute"
}
