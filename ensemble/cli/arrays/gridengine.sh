#!/usr/bin/env bash
#$ -N @NAME@
#$ -t 1-@PARTS@
@SLOTS@
#$ -l s_rt=@SOFT_SECONDS@,h_rt=@SECONDS@
#$ -notify
#$ -r y
#$ -cwd
#$ -V
#$ -S /bin/bash
#$ -j y
#$ -o @LOG@.part$TASK_ID.log
#
# @HEAD@
#
#     qsub @SCRIPT@                       # again: resumes what is not complete
#     qsub -t 7-9 @SCRIPT@                # only these parts
@NEXT@
#
# Two minutes before its time limit (SIGUSR1) and before it is rescheduled or killed (SIGUSR2, -notify) a task keeps what
# is done; it ends with 99, on which Grid Engine puts it back into the queue, and resumes. qdel ends it.
set -euo pipefail
@TASK@
status=0
compute "$SGE_TASK_ID" || status=$?
if ((status == 85 || status >= 128)); then exit 99; fi
exit "$status"
