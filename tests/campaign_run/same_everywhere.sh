# One campaign on 1 and 2 threads, on 1, 2 and 3 ranks, and with 1, 2 and 3 writers: the same file.
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
for number in 2 3; do
    expect 0 writers "${MPIRUN[@]}" -n 3 "$FLOES" run campaign.toml -o "writers$number.h5" --writers "$number"
    same alone.h5 "writers$number.h5"
    [ "$(find . -name "writers$number.journal.*" | wc -l)" -eq $((number - 1)) ] || fail "not $number writers"
    said writers "8 of 8 done, 0 failed"
    # Its journals are one: they are resumed, verified and merged by the name of the first.
    expect 0 again "$FLOES" run campaign.toml -o "writers$number.h5" --resume
    said again "8 members reused, 0 computed"
    same alone.h5 "writers$number.h5"
    expect 0 verify "$FLOES" verify "writers$number.journal"
    said verify "good, journal, 8 members"
    expect 0 merge "$FLOES" merge "writers$number.h5" -o "merged$number.h5"
    same alone.h5 "merged$number.h5"
done

# The many cores need not wait for the file.
expect 0 no_file "${MPIRUN[@]}" -n 3 "$FLOES" run campaign.toml -o late.h5 --writers 2 --no-file
said no_file "8 of 8 done, 0 failed"
said no_file "the results are in late.journal; to write late.h5, one core is enough: "
[ ! -e late.h5 ] || fail "--no-file wrote a file"
expect 0 late "$FLOES" run campaign.toml -o late.h5 --resume
said late "8 members reused, 0 computed"
same alone.h5 late.h5
expect 0 over "$FLOES" merge alone.h5 -o late.h5 --overwrite
[ ! -e late.journal.1 ] || fail "a merge left a piece of what it replaced"
same alone.h5 late.h5
