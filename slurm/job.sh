# Sourced by the scripts of this folder, inside a job: finds the program, and runs a campaign as a job should.
#
# FLOES_HOME      the folder of floes; where sbatch was called when not set
# FLOES           the program; the release build in that folder when not set
# FLOES_RESTARTS  how often a job may put itself back into the queue; 100 when not set
# shellcheck shell=bash

FLOES=${FLOES:-${FLOES_HOME:-$SLURM_SUBMIT_DIR}/build/release/floes}
if [[ ! -x $FLOES ]]; then
    echo "floes: there is no program $FLOES; ./floes --help, before you submit, builds it" >&2
    exit 2
fi

# Where the job has a part of a node: no more members at a time than it has cores, whether Slurm confines it or not.
# shellcheck disable=SC2034  # the scripts use it
threads=(${SLURM_CPUS_PER_TASK:+--threads "$SLURM_CPUS_PER_TASK"})

# in_job COMMAND…: does not return. Passes the request to stop on to the command (mpirun hands it to every rank on every
# node), and puts the job back into the queue when the command ends with 85, "stopped, resume me", or was killed (128 and
# above): mpirun notices a lost node long before Slurm does. A member that kills its process again and again is set aside.
in_job() {
    local child status=0 cancelled='' restarts=${SLURM_RESTART_COUNT:-0} limit=${FLOES_RESTARTS:-100}
    echo "floes: job $SLURM_JOB_ID, start $((restarts + 1)), on $SLURM_JOB_NODELIST, $(date -u +%FT%TZ)" >&2
    "$@" &
    child=$!
    # SIGUSR1: the time is nearly over (--signal). SIGTERM that comes first: scancel, and then the queue is not wanted.
    # mpirun would kill the ranks on SIGTERM; SIGUSR1 it passes on.
    trap 'trap : TERM; kill -USR1 "$child"' USR1
    trap 'cancelled=yes; kill -USR1 "$child"' TERM
    while kill -0 "$child" 2>/dev/null; do
        wait "$child" || true  # a signal ends this wait, not the child
    done
    wait "$child" || status=$?
    if [[ $cancelled ]]; then
        echo "floes: cancelled; the same sbatch goes on with what is done" >&2
        exit "$status"
    fi
    ((status == 85 || status >= 128)) || exit "$status"
    if ((restarts >= limit)); then
        echo "floes: ended with $status and not put back into the queue after $restarts restarts" >&2
    elif scontrol requeue "$SLURM_JOB_ID"; then
        echo "floes: ended with $status and put back into the queue, restart $((restarts + 1)) of at most $limit" >&2
    else
        echo "floes: ended with $status, and Slurm did not take the job back unless it had done so already" >&2
    fi
    exit "$status"
}
