#!/usr/bin/env bash
#HQ --name=@NAME@
#HQ --array=1-@PARTS@
#HQ --cpus=@CORES@
#HQ --stdout=none
#HQ --stderr=@LOG@.part%{TASK_ID}.log
#HQ --crash-limit=100
#
# @HEAD@
#
#     hq submit @SCRIPT@                  # again: resumes what is not complete
#     hq submit --array=7-9 @SCRIPT@      # only these parts
@NEXT@
#
# Workers come and go: a task whose worker is lost is started again on another one, and resumes.
set -euo pipefail
@TASK@
status=0
compute "$HQ_TASK_ID" || status=$?
exit "$status"
