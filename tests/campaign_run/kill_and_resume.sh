# kill -9 in the middle, then --resume: the file of an undisturbed campaign. Alone, a worker rank, and the master.
source "$(dirname "$0")/common.sh"

expect 0 whole "$FLOES" run campaign.toml -o whole.h5

"$FLOES" run campaign.toml -o alone.h5 > alone.log 2>&1 &
wait_for_a_member alone.journal
kill -9 $! || true
wait $! || true
expect 0 alone_resumed "$FLOES" run campaign.toml -o alone.h5 --resume
said alone_resumed "resumed: "
same whole.h5 alone.h5

for victim in 0 1; do
    "${MPIRUN[@]}" -n 2 bash -c 'if [ "${OMPI_COMM_WORLD_RANK:-$PMI_RANK}" = "$0" ]; then echo $$ > victim.pid; fi; exec "$@"' \
        "$victim" "$FLOES" run campaign.toml -o "ranks$victim.h5" > "ranks$victim.log" 2>&1 &
    wait_for_a_member "ranks$victim.journal"
    kill -9 "$(cat victim.pid)" || true
    wait $! || true
    expect 0 "resumed$victim" "${MPIRUN[@]}" -n 2 "$FLOES" run campaign.toml -o "ranks$victim.h5" --resume
    same whole.h5 "ranks$victim.h5"
done
