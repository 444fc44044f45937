#!/usr/bin/env bash
#SBATCH --job-name=@NAME@
#SBATCH --array=1-@PARTS@
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=@CORES@
#SBATCH --time=@HOURS@:00:00
#SBATCH --signal=B:USR1@120
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=@LOG@.part%a.log
#
# @HEAD@
#
#     sbatch @SCRIPT@                     # again: resumes what is not complete
#     sbatch --array=3,7-9 @SCRIPT@       # only these parts
@NEXT@
#
# Two minutes before its time limit, and when it was killed, a task goes back into the queue and resumes. scancel ends it.
set -euo pipefail
@TASK@
status=0
compute "$SLURM_ARRAY_TASK_ID" || status=$?
if [[ ! $cancelled ]] && ((status == 85 || status >= 128)) && ((${SLURM_RESTART_COUNT:-0} < 100)); then
    timeout 120 scontrol requeue "$SLURM_JOB_ID" || true
fi
exit "$status"
