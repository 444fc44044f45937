# Sourced by the scripts of this folder, inside a job: finds the program and runs a campaign in the job.
#
# FLOES_HOME      the folder of floes; default: the folder where sbatch was called, or where floes is installed
# FLOES           the program; default: the release build in that folder, or the installed one
# FLOES_RESTARTS  how often a job may requeue itself; default: 100
# shellcheck shell=bash

if [[ -z ${FLOES-} ]]; then
    FLOES=${home:?}/build/release/floes
    [[ -x $FLOES ]] || FLOES=$(command -v floes || echo "$FLOES")
fi
if [[ ! -x $FLOES ]]; then
    echo "floes: the program $FLOES does not exist; build it with ./floes --help before you submit, or install it" >&2
    exit 2
fi

# If the job has only part of a node: no more members at a time than it has cores, even if Slurm does not enforce this.
# shellcheck disable=SC2034  # the scripts use it
threads=(${SLURM_CPUS_PER_TASK:+--threads "$SLURM_CPUS_PER_TASK"})

# in_job COMMAND…: does not return. Forwards the request to stop to the command; mpirun forwards it to every rank on
# every node. Requeues the job if the command ends with 85 ("stopped, resume") or was killed (128 and above), because
# mpirun detects a lost node long before Slurm does. A member that kills its process repeatedly is set aside as failed.
in_job() {
    local child status=0 cancelled='' restarts=${SLURM_RESTART_COUNT:-0} limit=${FLOES_RESTARTS:-100}
    echo "floes: job $SLURM_JOB_ID, start $((restarts + 1)), on $SLURM_JOB_NODELIST, $(date -u +%FT%TZ)" >&2
    "$@" &
    child=$!
    # SIGUSR1: the time limit is near (--signal). A SIGTERM before it comes from scancel, and then the job must not be
    # requeued. mpirun would kill the ranks on SIGTERM, but it forwards SIGUSR1.
    trap 'trap : TERM; kill -USR1 "$child" 2>/dev/null || true' USR1
    trap 'cancelled=yes; kill -USR1 "$child" 2>/dev/null || true' TERM
    while kill -0 "$child" 2>/dev/null; do
        wait "$child" || true  # a signal ends this wait, not the child
    done
    wait "$child" || status=$?
    if [[ $cancelled ]]; then
        echo "floes: cancelled; the same sbatch command resumes the campaign" >&2
        exit "$status"
    fi
    ((status == 85 || status >= 128)) || exit "$status"
    if ((restarts >= limit)); then
        echo "floes: ended with $status and not requeued after $restarts restarts" >&2
    elif timeout 120 scontrol requeue "$SLURM_JOB_ID"; then
        echo "floes: ended with $status and requeued, restart $((restarts + 1)) of at most $limit" >&2
    else
        echo "floes: ended with $status; scontrol did not requeue the job (Slurm may have requeued it already)" >&2
    fi
    exit "$status"
}
