# SIGTERM, SIGINT or SIGUSR1 in the middle: exit status 85, a whole campaign file, and a command that completes it.
source "$(dirname "$0")/common.sh"

# stopped NAME SIGNAL PID: sends it and fails unless the process ends with 85 (or was done first).
stopped() {
    local status=0
    kill "-$2" "$3" || true
    wait "$3" || status=$?
    [ "$status" -eq 85 ] || fail "$1 ended with $status instead of 85 on $2"
    "$FLOES" verify "$1.h5" > verify.log 2>&1 || fail "$1.h5 is not whole"
}

# told NAME WORDS: fails unless the command of --on-end wrote these to NAME.told.
told() {
    [ "$(cat "$1.told")" = "$2" ] || fail "--on-end was told '$(cat "$1.told")' and not '$2'"
}

expect 0 whole "$FLOES" run campaign.toml -o whole.h5 --metrics whole.prom --on-end \
    'echo "$FLOES_OUTCOME $FLOES_EXIT_STATUS $FLOES_DONE $FLOES_FAILED $FLOES_MISSING $FLOES_CAMPAIGN_FILE" > whole.told'
told whole "done 0 8 0 0 whole.h5"
grep -q "^floes_members{campaign=\".*\",state=\"done\"} 8\$" whole.prom || fail "metrics: $(cat whole.prom)"

"$FLOES" run campaign.toml -o alone.h5 --threads 1 --set campaign.seed=1 > alone.log 2>&1 &
wait_for_a_member alone.journal
stopped alone TERM $!
said alone "stopped by SIGTERM"
command=$(sed -n 's/.*to resume: //p' alone.log)
[ "$command" = "$FLOES run campaign.toml -o alone.h5 --resume --threads 1 --set campaign.seed=1" ] ||
    fail "the command to resume is '$command'"
expect 0 alone_resumed bash -c "$command"
said alone_resumed "resumed: "
same whole.h5 alone.h5

# The terminal is closed.
"$FLOES" run campaign.toml -o closed.h5 --threads 1 --on-end 'echo "$FLOES_OUTCOME $FLOES_EXIT_STATUS" > closed.told' \
    > closed.log 2>&1 &
wait_for_a_member closed.journal
stopped closed HUP $!
said closed "stopped by SIGHUP"
told closed "stopped 85"
expect 0 closed_resumed "$FLOES" run campaign.toml -o closed.h5 --resume
same whole.h5 closed.h5

# Nobody reads what it prints any more, and it goes on.
"$FLOES" run campaign.toml -o piped.h5 --threads 1 2>&1 | head -c 20 > piped.log || fail "a run ended with its reader"
same whole.h5 piped.h5

# The same command serves for the first start and every later one.
for attempt in 1 2; do
    "$FLOES" run campaign.toml -o again.h5 --threads 1 --resume > again.log 2>&1 &
    pid=$!
    if [ "$attempt" -eq 1 ]; then
        wait_for_a_member again.journal
    else
        until grep -q "resumed:" again.log; do sleep 0.01; done  # members are done in no time: no fixed wait
    fi
    stopped again INT "$pid"
done
expect 0 again_resumed "$FLOES" run campaign.toml -o again.h5 --resume
same whole.h5 again.h5

# Under mpirun, which passes SIGUSR1 to every rank.
"${MPIRUN[@]}" -n 2 "$FLOES" run campaign.toml -o ranks.h5 > ranks.log 2>&1 &
wait_for_a_member ranks.journal
stopped ranks USR1 $!
said ranks " $FLOES run campaign.toml -o ranks.h5 --resume"
said ranks "to resume: mpirun -n 2 "
expect 0 ranks_resumed "${MPIRUN[@]}" -n 3 "$FLOES" run campaign.toml -o ranks.h5 --resume
same whole.h5 ranks.h5

# --ranks calls mpirun, and Ctrl-C asks its ranks to stop. What a script starts in the background ignores SIGINT.
env FLOES_MPIRUN="$MPIEXEC" --default-signal=INT "$FLOES" run --ranks 2 campaign.toml -o own.h5 \
    --set campaign.arrangements=20 > own.log 2>&1 &
wait_for_a_member own.journal
stopped own INT $!
said own "to resume: $FLOES run --ranks 2 campaign.toml -o own.h5 --resume --set campaign.arrangements=20"
expect 0 own_resumed env FLOES_MPIRUN="$MPIEXEC" bash -c "$(sed -n 's/.*to resume: //p' own.log)"
said own_resumed "40 of 40 done"
expect 2 own_wrong "${MPIRUN[@]}" -n 2 "$FLOES" run --ranks 3 campaign.toml -o wrong.h5
said own_wrong "--ranks 3 inside mpirun, which started 2 ranks"
expect 1 own_missing env FLOES_MPIRUN=no-such-mpirun "$FLOES" run --ranks 2 campaign.toml -o missing.h5
said own_missing "no-such-mpirun could not be started"
for ranks in 0 -1 two 1.5 ''; do expect 2 own_refused "$FLOES" run campaign.toml --ranks "$ranks"; done

# A signal to one worker alone stops them all.
"${MPIRUN[@]}" -n 2 bash -c 'if [ "${OMPI_COMM_WORLD_RANK:-$PMI_RANK}" = 1 ]; then echo $$ > worker.pid; fi; exec "$@"' _ \
    "$FLOES" run campaign.toml -o worker.h5 > worker.log 2>&1 &
wait_for_a_member worker.journal
kill -USR1 "$(cat worker.pid)"
status=0
wait $! || status=$?
[ "$status" -eq 85 ] || fail "the ranks ended with $status instead of 85"
said worker "stopped by a signal to rank 1"
