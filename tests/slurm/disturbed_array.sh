# Sourced by the tests of job arrays: what they do with 16 parts of campaign.toml, whichever system computes them. Some
# parts, drawn by a seed that is told (FLOES_SEED repeats it), fall asleep in their first start once they have a member, and
# are then put back into the queue, asked to stop, or killed.
SEED=${FLOES_SEED:-$RANDOM}
RANDOM=$SEED
echo "seed $SEED"
FULL=5  # this part finds a full disk in every start until disk.is_full is gone: a limit to the size of files stands for it
mapfile -t HELD < <(for part in $(seq 16); do [ "$part" = $FULL ] || echo "$RANDOM $part"; done | sort -n | head -6 |
    cut -d' ' -f2 | sort -n)

touch disk.is_full
cat > floes_here <<SH
#!/usr/bin/env bash
[[ " \$* " =~ " --part "([0-9]+)/16" " ]] || exec $PROGRAM "\$@"
part=\${BASH_REMATCH[1]}
if [[ \$part == $FULL && -e $FOLDER/disk.is_full ]]; then
    trap '' XFSZ
    ulimit -f 20
fi
[[ " ${HELD[*]} " == *" \$part "* && ! -e $FOLDER/held.\$part ]] || exec $PROGRAM "\$@"
touch $FOLDER/held.\$part
nice -n 10 $PROGRAM "\$@" &  # so that what watches it is not late
child=\$!
source $FLOES_HOME/tests/slurm/sleeping.sh
trap 'ask_and_wake \$child' USR1 TERM
# A journal with a member: 2.6 kB of header, 1.4 kB of session at most, 4.3 kB of a member at least.
until [[ \$(stat -c %s $FOLDER/campaign.part\$part.journal 2> /dev/null || echo 0) -gt 6000 ]]; do sleep 0.02; done
put_to_sleep \$child
touch $FOLDER/asleep.\$part
while kill -0 \$child 2> /dev/null; do wait \$child; done
wait \$child
SH
chmod +x floes_here
export FLOES=$FOLDER/floes_here

# kill_part PART: the process that leads it.
kill_part() {
    local pid
    for pid in $(cluster_pids); do
        if { tr '\0' ' ' < "/proc/$pid/cmdline"; } 2> /dev/null | grep -q "^$PROGRAM run .*--part $1/16 "; then
            kill -KILL "$pid" 2> /dev/null || true
        fi
    done
}

# disturb_parts: each that sleeps, by requeue PART, ask_to_stop PART and kill_part PART in turn. Meanwhile, what can be
# read while tasks run.
disturb_parts() {
    local part ways=(requeue ask_to_stop kill_part) k=0
    for part in "${HELD[@]}"; do
        until_true 240 test -e "asleep.$part" || fail "part $part has no member after four minutes"
        [ $k != 2 ] || while_it_runs
        "${ways[k++ % 3]}" "$part"
    done
}

while_it_runs() {
    "$PROGRAM" status campaign.part*.h5 > status.log 2>&1 || fail "parts have no status while they run"
    said status.log "of 64 members done"
    said status.log "Running: "
    "$PROGRAM" summarize campaign.part*.h5 > summary.log 2>&1 || fail "parts have no summary while they run"
    said summary.log "of 64 members have no result yet"
    "$PROGRAM" merge campaign.part*.h5 -o campaign.h5 > merge.log 2>&1 && fail "all members are there while parts run"
    said merge.log "of 64 members done"
}

# all_but_the_full_one_are_done: the rest is told. The disk is full no longer.
all_but_the_full_one_are_done() {
    said "campaign.part$FULL.log" "Is the disk full"
    "$PROGRAM" merge campaign.part*.h5 -o campaign.h5 > merge.log 2>&1 && fail "all members are there despite a full disk"
    said merge.log "Of 16 parts there is no file of part $FULL."
    said merge.log "missing: all of arrangements $((FULL - 1)), $((FULL + 15))."
    said "campaign.part${HELD[0]}.log" " of 4 members done and on the disk"  # put back into the queue
    said "campaign.part${HELD[1]}.log" "ended with 85"                        # asked to stop
    said "campaign.part${HELD[2]}.log" "ended with 137"                       # killed
    local part
    for part in "${HELD[@]}"; do said "campaign.part$part.log" "resumed: "; done
    rm disk.is_full
}

all_is_one_run() {
    "$PROGRAM" merge campaign.part*.h5 -o campaign.h5 > merge.log 2>&1 || fail "members are missing"
    said merge.log "64 of 64 members done, 0 failed, 0 missing"
    same whole.h5 campaign.h5
    "$PROGRAM" merge campaign.part*.h5 -o afresh.h5 > afresh.log 2>&1 || fail "the parts cannot be merged at once"
    same whole.h5 afresh.h5
    "$PROGRAM" verify campaign.h5 afresh.h5 > verify.log 2>&1 || fail "the merged files are not whole"
}
