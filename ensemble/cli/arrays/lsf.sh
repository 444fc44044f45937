#!/usr/bin/env bash
#BSUB -J "@NAME@[1-@PARTS@]"
#BSUB -n @CORES@
#BSUB -R "span[hosts=1]"
#BSUB -W @HOURS@:00
#BSUB -wa USR1
#BSUB -wt 5
#BSUB -Q "85"
#BSUB -r
#BSUB -o @LOG@.part%I.log
#
# @HEAD@
#
#     bsub < @SCRIPT@                     # again: resumes what is not complete
@NEXT@
#
# Five minutes before its time limit (-wa, -wt) a task keeps what is done and ends with 85, on which LSF puts it back into
# the queue (-Q). After a lost host LSF starts it again (-r).
set -euo pipefail
@TASK@
status=0
compute "$LSB_JOBINDEX" || status=$?
exit "$status"
