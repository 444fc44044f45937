# Members that are stopped or killed in their middle go on where they were saved, on any rank, to the same file.
source "$(dirname "$0")/common.sh"

# Of two cases: two members. Of some seconds each, so that none ends between its first save and the signal.
channel 12 1 96.0 0.004 > long.toml
SAVING=(--checkpoint-min 0.005 --threads 2)

# wait_for_saved NAME: until both members have a file.
wait_for_saved() {
    for _ in $(seq 3000); do
        if [ "$(find . -name "$1.*.saved" | wc -l)" -eq 2 ]; then return; fi
        sleep 0.02
    done
    fail "no member of $1 was saved within a minute"
}

# gone NAME: fails if a file of a member that is done is still there.
gone() {
    [ -z "$(find . -name "$1.*.saved*")" ] || fail "$1 left $(find . -name "$1.*.saved*")"
}

expect 0 whole "$FLOES" run long.toml -o whole.h5 --checkpoint-min 0
gone whole

for signal in TERM KILL; do
    for isolation in none process; do
        name=$signal$isolation
        "$FLOES" run long.toml -o "$name.h5" "${SAVING[@]}" --isolation $isolation > "$name.log" 2>&1 &
        pid=$!
        wait_for_saved "$name"
        kill "-$signal" $pid
        status=0
        wait $pid || status=$?
        [ $signal = KILL ] || [ $status -eq 85 ] || fail "$name ended with $status instead of 85"
        [ "$(find . -name "$name.*.saved" | wc -l)" -eq 2 ] || fail "$name kept no saved members"
        expect 0 "${name}_resumed" "$FLOES" run long.toml -o "$name.h5" "${SAVING[@]}" --isolation $isolation --resume
        said "${name}_resumed" "2 of them from where they were saved"
        same whole.h5 "$name.h5"
        gone "$name"
    done
done

# Other ranks continue them; a damaged file is not used.
"$FLOES" run long.toml -o ranks.h5 "${SAVING[@]}" > ranks.log 2>&1 &
pid=$!
wait_for_saved ranks
kill -TERM $pid
wait $pid || true
damaged=$(find . -name "ranks.*.saved" | head -1)
truncate -s -100 "$damaged"
expect 0 ranks_resumed "${MPIRUN[@]}" -n 2 "$FLOES" run long.toml -o ranks.h5 --threads 1 --checkpoint-min 0.005 --resume
said ranks_resumed "begins at its start, since"
same whole.h5 ranks.h5
gone ranks

# --overwrite begins anew.
"$FLOES" run long.toml -o anew.h5 "${SAVING[@]}" > anew.log 2>&1 &
pid=$!
wait_for_saved anew
kill -TERM $pid
wait $pid || true
expect 0 anew_again "$FLOES" run long.toml -o anew.h5 "${SAVING[@]}" --overwrite
same whole.h5 anew.h5
gone anew
