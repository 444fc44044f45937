# floes array under Grid Engine: 16 parts on two slots, some of them rescheduled, asked to stop and killed, one on a full
# disk. What is merged meanwhile and at the end is the file of one undisturbed run.
# Members of some tenths of a second on an idle core, so that a part falls asleep before its last one.
export ARRANGEMENTS=32 WINDOW=21.0 STEP=0.002
source "$(dirname "$0")/cell.sh"
source "$(dirname "$0")/../slurm/disturbed_array.sh"

requeue() {
    qmod -rj "$job.$1" > /dev/null
}

# As Grid Engine does at the limit s_rt: SIGUSR1 to the group of the task.
ask_to_stop() {
    local pid
    for pid in $(cluster_pids); do
        if { tr '\0' '\n' < "/proc/$pid/environ"; } 2> /dev/null | grep -qx "SGE_TASK_ID=$1"; then
            kill -USR1 -- "-$(ps -o pgid= -p "$pid" | tr -d ' ')"
            return
        fi
    done
    fail "there is no process of task $1"
}

"$PROGRAM" array campaign.toml --for gridengine --parts 16 --cores 1 2> array.log
job=$(submit campaign.gridengine.sh)
disturb_parts
ends "$job" 300
all_but_the_full_one_are_done
job=$(submit -t $FULL campaign.gridengine.sh)
ends "$job" 60
all_is_one_run

# qdel ends a task, which keeps what is done and does not come back.
rm held.* asleep.* campaign.part"${HELD[0]}".*
job=$(submit -t "${HELD[0]}" campaign.gridengine.sh)
until_true 240 test -e "asleep.${HELD[0]}" || fail "part ${HELD[0]} has no member after four minutes"
qdel "$job" > /dev/null
ends "$job" 60
said "campaign.part${HELD[0]}.log" " of 4 members done and on the disk"
