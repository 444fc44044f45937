# One campaign on 1 and 2 threads, on 1, 2 and 3 ranks, and with 1, 2 and 3 writers: the same file.
source "$(dirname "$0")/common.sh"

expect 0 alone "$FLOES" run campaign.toml -o alone.h5
said alone "8 members = 2 cases x 4 arrangements"
said alone "8 of 8 done, 0 failed"
[ ! -e alone.journal ] || fail "the journal is left of a campaign that is whole in its file"
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
    expect 0 writers "${MPIRUN[@]}" -n 3 "$FLOES" run campaign.toml -o "writers$number.h5" --writers "$number" --keep-journal
    same alone.h5 "writers$number.h5"
    [ "$(find . -name "writers$number.journal.*" | wc -l)" -eq $((number - 1)) ] || fail "not $number writers"
    said writers "8 of 8 done, 0 failed"
    # Each has published a piece; every verb reads the file, also where both have been moved.
    [ "$(find "writers$number.pieces" -name "1-*.h5" | wc -l)" -eq "$number" ] || fail "not $number pieces"
    mkdir moved && cp -r "writers$number.h5" "writers$number.pieces" moved
    expect 0 pieces "$FLOES" verify "moved/writers$number.h5" "moved/writers$number.pieces/1-1.h5"
    said pieces "datasets in $number pieces, digest $("$FLOES" verify alone.h5 | sed "s/.*digest //")"
    for verb in summarize status report replay; do
        given=("moved/writers$number.h5")
        [ "$verb" != report ] || given+=(-o "report$number.html")
        [ "$verb" != replay ] || given+=(3 -o "replay$number.html")
        expect 0 "$verb" "$FLOES" "$verb" "${given[@]}"
    done
    rm "moved/writers$number.pieces/1-2.h5"
    expect 2 lacking "$FLOES" summarize "moved/writers$number.h5"
    said lacking "writers$number.pieces/1-2.h5 with arrangement"
    expect 1 lacking "$FLOES" verify "moved/writers$number.h5"
    said lacking "writers$number.pieces/1-2.h5 with arrangement"
    rm -r moved
    # Its journals are one: they are resumed, verified and merged by the name of the first.
    expect 0 again "$FLOES" run campaign.toml -o "writers$number.h5" --resume --keep-journal
    said again "8 members reused, 0 computed"
    [ ! -e "writers$number.pieces" ] || fail "a file with rows of its own left pieces"
    same alone.h5 "writers$number.h5"
    expect 0 verify "$FLOES" verify "writers$number.journal"
    said verify "good, journal, 8 members"
    expect 0 merge "$FLOES" merge "writers$number.h5" -o "merged$number.h5"
    same alone.h5 "merged$number.h5"
done

# A campaign in pieces grows, by other writers: the old pieces stay until the new file stands.
expect 0 small "${MPIRUN[@]}" -n 3 "$FLOES" run campaign.toml -o grown.h5 --writers 3 --set campaign.arrangements=2
[ "$(find grown.pieces -name "1-*.h5" | wc -l)" -eq 2 ] || fail "more pieces than arrangements"
[ -z "$(find . -name "grown.journal*")" ] || fail "journals are left of a campaign that is whole in its file"
expect 0 grown "${MPIRUN[@]}" -n 3 "$FLOES" run campaign.toml -o grown.h5 --writers 2 --resume
said grown "4 members reused, 4 computed"
[ "$(find grown.pieces -type f | sort | xargs)" = "grown.pieces/2-1.h5 grown.pieces/2-2.h5" ] || fail "other pieces"
same alone.h5 grown.h5
expect 0 over "$FLOES" run campaign.toml -o grown.h5 --resume
said over "grown.h5 has all of 8 members: nothing is left to compute"
expect 0 solid "$FLOES" merge grown.h5 -o solid.h5
same alone.h5 solid.h5
[ -z "$(find . -name "grown.journal*" -o -name "solid.journal*" -o -name "solid.pieces")" ] || fail "a merge left more than a file"

# What only the file has comes into a journal that lacks it: here the member of a bit that was flipped.
expect 0 flipped "$FLOES" run campaign.toml -o flipped.h5 --keep-journal
printf x | dd of=flipped.journal bs=1 seek=$(($(stat -c %s flipped.journal) / 2)) conv=notrunc status=none
expect 0 flipped "$FLOES" run campaign.toml -o flipped.h5 --resume
said flipped "8 members reused, 0 computed"
same alone.h5 flipped.h5

# The many cores need not wait for the file.
expect 0 no_file "${MPIRUN[@]}" -n 3 "$FLOES" run campaign.toml -o late.h5 --writers 2 --no-file
said no_file "8 of 8 done, 0 failed"
said no_file "the results are in late.journal; to write late.h5, one core is enough: "
[ ! -e late.h5 ] || fail "--no-file wrote a file"
expect 0 late "$FLOES" run campaign.toml -o late.h5 --resume
said late "8 members reused, 0 computed"
same alone.h5 late.h5
[ -z "$(find . -name "late.journal*")" ] || fail "journals are left of a campaign that is whole in its file"
expect 0 over "$FLOES" merge alone.h5 -o late.h5 --overwrite
[ -z "$(find . -name "late.journal*")" ] || fail "a merge left a journal of what it replaced"
same alone.h5 late.h5
