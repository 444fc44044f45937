# floes array under Slurm: 16 parts on two nodes, of which one comes late and goes again; some parts are put back into the
# queue, asked to stop and killed, one finds a full disk. What is merged meanwhile and at the end is the file of one
# undisturbed run.
# Members of some tenths of a second on an idle core, so that a part falls asleep before its last one.
export ARRANGEMENTS=32 WINDOW=21.0 STEP=0.002
source "$(dirname "$0")/cluster.sh"
source "$(dirname "$0")/disturbed_array.sh"

requeue() {
    until_true 20 scontrol requeue "${job}_$1" || fail "part $1 cannot be put back into the queue"
}

# scancel may find the task requeued already, and repeat for a minute what had its effect; the log tells.
ask_to_stop() {
    timeout 3 scancel --batch --signal=USR1 "${job}_$1" 2> /dev/null || true
}

other=$(submit --exclusive --nodelist=n2 --time=30 --wrap "sleep 600")  # has one node for a while
"$PROGRAM" array campaign.toml --for slurm --parts 16 --cores 1 2> array.log
job=$(submit campaign.slurm.sh)
until_true 60 test -e campaign.part1.h5 || fail "no part began in a minute"
scancel "$other"
disturb_parts
scontrol update nodename=n2 state=down reason=gone  # Slurm puts what runs there back into the queue
sleep 2
scontrol update nodename=n2 state=resume
until_true 300 is_over "$job" || fail "job $job has not ended"
all_but_the_full_one_are_done
job=$(submit --array=$FULL campaign.slurm.sh)
until_true 60 is_over "$job" || fail "job $job has not ended"
all_is_one_run

# scancel ends a task, which keeps what is done and does not come back.
rm held.* asleep.* campaign.part"${HELD[0]}".*
job=$(submit --array="${HELD[0]}" campaign.slurm.sh)
until_true 240 test -e "asleep.${HELD[0]}" || fail "part ${HELD[0]} has no member after four minutes"
until_true 20 scancel "$job" || fail "job $job cannot be cancelled"
until_true 60 is_over "$job" || fail "job $job has not ended"
said "campaign.part${HELD[0]}.log" " of 4 members done and on the disk"
ends "${job}_${HELD[0]}" CANCELLED 5
