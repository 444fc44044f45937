#!/usr/bin/env bash
#
# @HEAD@
#
#     bash @SCRIPT@                                    # on this machine
#     bash @SCRIPT@ --sshlogin :,me@workstation        # and on that one, which sees this folder under the same path
@NEXT@
#
# One part at a time on each machine, which uses @CORES_WORDS@. A part whose machine is lost is computed on
# another one. Ctrl-C twice ends all parts; they keep what is done, and the same command resumes. Options go to GNU parallel.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"
@TASK@
if [[ ${1-} == compute ]]; then
    compute "$2"
    exit
fi
exec parallel --jobs 1 --line-buffer --retries 3 --termseq USR1,60000,TERM,1000,KILL --env FLOES "$@" \
    "bash $(printf '%q' "$PWD/")@SCRIPT@ compute {}" ::: $(seq @PARTS@)
