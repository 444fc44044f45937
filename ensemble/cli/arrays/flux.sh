#!/usr/bin/env bash
#
# @HEAD@
#
#     bash @SCRIPT@                       # submits; again: resumes what is not complete
#     bash @SCRIPT@ 3,7-9                 # only these parts
@NEXT@
#
# Two minutes before its time limit a task keeps what is done, submits itself again, and resumes.
set -euo pipefail
submit() {
    timeout 120 flux submit --cc="$1" --ntasks=1 --cores-per-task=@CORES@ --time-limit=@HOURS@h --signal=USR1@2m \
        --job-name=@NAME@ --output='@LOG@.part{cc}.log' bash @SCRIPT@
}
if [[ -z ${FLUX_JOB_CC-} ]]; then
    submit "${1:-1-@PARTS@}"
    exit
fi
@TASK@
status=0
compute "$FLUX_JOB_CC" || status=$?
if [[ ! $cancelled ]] && ((status == 85)); then submit "$FLUX_JOB_CC"; fi
exit "$status"
