# floes array: bash TEST.sh FLOES. The script for every system is one to bash and to shellcheck; what it does in a task is
# tried in the environment that its system gives a task, made up here. GNU parallel is real, but not its ssh to another
# machine. The real Slurm and Grid Engine: array.sh, here and in ../gridengine. Then a part on a clock that is off.
set -euo pipefail
FLOES=$1
FOLDER=$(mktemp -d)
trap 'rm -rf "$FOLDER"' EXIT
fail() {
    echo "FAILED: $*" >&2
    tail -n +1 "$FOLDER"/*.log >&2
    exit 1
}
source "$(dirname "$0")/small_campaign.sh"

for system in slurm gridengine pbs lsf flux hyperqueue parallel; do
    "$FLOES" array campaign.toml --for $system --parts 3 --cores 2 -o $system.h5 > written.log 2>&1 ||
        fail "there is no script for $system"
    said written.log "$system.$system.sh"
    bash -n $system.$system.sh || fail "$system.$system.sh is no script"
    shellcheck $system.$system.sh > shellcheck.log || fail "shellcheck finds fault with $system.$system.sh"
done
"$FLOES" array campaign.toml --for slurm -o slurm.h5 > again.log 2>&1 && fail "a script was replaced"
said again.log "exists already"

# flux and scontrol write down what they are asked; flux gives no task to anybody.
mkdir stubs
for program in flux scontrol; do
    printf '#!/bin/sh\necho "%s $*" >> %s/asked.log\n' $program "$FOLDER" > stubs/$program
done
chmod +x stubs/*
export PATH=$FOLDER/stubs:$PATH

# task SYSTEM PART: as that system would start it.
task() {
    case $1 in
        slurm) SLURM_ARRAY_TASK_ID=$2 SLURM_JOB_ID=7 bash slurm.slurm.sh ;;
        gridengine) SGE_TASK_ID=$2 bash gridengine.gridengine.sh ;;
        pbs) (export PBS_ARRAY_INDEX=$2 PBS_O_WORKDIR=$PWD && cd / && bash "$FOLDER/pbs.pbs.sh") ;;
        lsf) LSB_JOBINDEX=$2 bash < lsf.lsf.sh ;;
        flux) FLUX_JOB_CC=$2 bash flux.flux.sh ;;
        hyperqueue) HQ_TASK_ID=$2 bash hyperqueue.hyperqueue.sh ;;
    esac
}

for system in slurm gridengine pbs lsf flux hyperqueue; do
    for part in 1 2 3; do
        task $system $part > task.log 2>&1 || fail "part $part does not run as a task of $system"
        said task.log "part $part of 3 ended with 0"
    done
    "$FLOES" merge $system.part*.h5 -o $system.h5 > merge.log 2>&1 || fail "parts of $system are not complete"
    same whole.h5 $system.h5
done
bash flux.flux.sh 2,3
said asked.log "flux submit --cc=2,3 --ntasks=1 --cores-per-task=2 --time-limit=1h --signal=USR1@2m"

# What a task does that was stopped (85) and that was killed (137), by a program that ends so.
printf '#!/bin/sh\n[ "$ENDS" != 137 ] || kill -9 $$\nexit "$ENDS"\n' > ends
chmod +x ends
# ends_with SYSTEM STATUS WANTED
ends_with() {
    local status=0
    ENDS=$2 FLOES=$FOLDER/ends task "$1" 1 > ends.log 2>&1 || status=$?
    [ $status = "$3" ] || fail "a task of $1 ends with $status in place of $3 after $2"
}
ends_with slurm 85 85
ends_with slurm 137 137
[ "$(grep -c "scontrol requeue 7" asked.log)" = 2 ] || fail "slurm is not asked to requeue"
ends_with slurm 1 1
[ "$(grep -c "scontrol requeue" asked.log)" = 2 ] || fail "slurm is asked to requeue what failed"
ends_with gridengine 85 99
ends_with gridengine 137 99
ends_with gridengine 1 1
ends_with lsf 85 85
ends_with flux 85 85
said asked.log "flux submit --cc=1 "
for system in pbs hyperqueue; do ends_with $system 2 2; done

# A laptop, a workstation and a third machine that ssh cannot reach: its parts are computed elsewhere.
cat > ssh <<'SH'
#!/usr/bin/env bash
while [[ $1 == -* ]]; do shift; done
host=$1
shift
echo "ssh to $host" >> ssh.log
[[ $host != nowhere ]] || exit 255
cd / && exec bash -c "$*"
SH
chmod +x ssh
PARALLEL_SSH=$FOLDER/ssh bash parallel.parallel.sh --sshlogin :,workstation > parallel.log 2>&1 ||
    fail "the parts do not run under GNU parallel"
said ssh.log "ssh to workstation"
"$FLOES" merge parallel.part*.h5 -o parallel.h5 > merge.log 2>&1 || fail "parts of parallel are not complete"
same whole.h5 parallel.h5

# A part that was run on a clock an hour off says so; its members are those of any other clock.
for hours in -1 +1; do
    rm -f slurm.part2.*
    NO_FAKE_STAT=1 DONT_FAKE_MONOTONIC=1 faketime -f "${hours}h" "$FLOES" run campaign.toml --part 2/3 -o slurm.part2.h5 \
        > clock.log 2>&1 || fail "part 2 does not run on another clock"
    "$FLOES" merge slurm.part*.h5 --overwrite -o slurm.h5 > merge.log 2>&1 || fail "parts of different clocks are not merged"
    said merge.log "slurm.part2.h5 was run on a clock that is off: "
    same whole.h5 slurm.h5
done
