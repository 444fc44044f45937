#!/usr/bin/env bash
#PBS -N @NAME@
@PBS_ARRAY@
#PBS -l select=1:ncpus=@CORES@
#PBS -l walltime=@HOURS@:00:00
#PBS -r y
#PBS -j oe
#
# @HEAD@
#
#     qsub @SCRIPT@                       # again: resumes what is not complete
#     qsub -J 7-9 @SCRIPT@                # only these parts
@NEXT@
#
# Of PBS Professional and OpenPBS. A task stops by itself before its time limit and keeps what is done; PBS does not put it
# back into the queue then, so the same qsub does. After a lost node it does (-r y).
set -euo pipefail
cd -- "$PBS_O_WORKDIR"
@TASK@
status=0
compute "${PBS_ARRAY_INDEX:-1}" --time-left @SECONDS@ || status=$?
exit "$status"
