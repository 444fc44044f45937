# One campaign on 1 and 2 threads and on 1, 2 and 3 ranks: the same file.
source "$(dirname "$0")/common.sh"

expect 0 alone "$FLOES" run campaign.toml -o alone.h5
said alone "8 members = 2 cases x 4 arrangements"
said alone "8 of 8 done, 0 failed"
for threads in 1 2; do
    expect 0 threads "$FLOES" run campaign.toml -o "threads$threads.h5" --threads "$threads"
    same alone.h5 "threads$threads.h5"
done
for number in 1 2 3; do
    expect 0 ranks "${MPIRUN[@]}" -n "$number" "$FLOES" run campaign.toml -o "ranks$number.h5"
    same alone.h5 "ranks$number.h5"
done
said ranks "of 3 ranks"
