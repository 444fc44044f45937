# A campaign in parts, one of them unfinished, merged: what is missing is said, then computed, and the file is that of an
# undisturbed campaign.
source "$(dirname "$0")/common.sh"

SHORT=(--set analysis.window_s=3.0)
expect 0 whole "$FLOES" run campaign.toml -o whole.h5 "${SHORT[@]}"
expect 0 first "$FLOES" run campaign.toml -o first.h5 --part 1/3 "${SHORT[@]}"
said first "part 1 of 3: 4 of these members"
said first "4 of 4 done, 0 failed"
expect 0 second "$FLOES" run campaign.toml -o second.h5 --part 2/3 "${SHORT[@]}"

expect 1 two "$FLOES" merge first.h5 second.h5 -o two.h5
said two "6 of 8 members done, 0 failed, 2 missing from all parts"
said two "Of 3 parts there is no file of part 3."
said two "2 members are missing: all of arrangement 2."
expect 0 seen "$FLOES" status first.h5 second.h5
said seen "6 of 8 members done, 0 failed, 2 to do"
said seen "None of 2 parts runs"
for verb in summarize report; do expect 0 "$verb" "$FLOES" $verb first.h5 second.h5; done
said summarize "2 of 8 members have no result yet"
expect 0 one_of_two "$FLOES" summarize two.h5 --format csv --parts members
expect 0 of_parts "$FLOES" summarize first.h5 second.h5 --format csv --parts members
cmp <(grep -v "^floes: " one_of_two.log) <(grep -v "^floes: " of_parts.log) || fail "parts have another summary than their merger"
expect 0 completed "$FLOES" run campaign.toml -o two.h5 --resume "${SHORT[@]}"
said completed "6 members reused, 2 to compute"
same whole.h5 two.h5

expect 0 third "${MPIRUN[@]}" -n 2 "$FLOES" run campaign.toml -o third.h5 --part 3/3 --writers 2 --threads 1 "${SHORT[@]}"
[ -e third.journal.1 ] || fail "not two writers"
expect 0 three "$FLOES" merge third.h5 second.h5 first.h5 first.h5 -o three.h5
same whole.h5 three.h5
[ -z "$(find . -name "three.journal*")" ] || fail "merging left a file behind"
[ -e first.journal ] || fail "a part lost its journal"

cp second.journal damaged.journal
printf x | dd of=damaged.journal bs=1 seek=$(($(stat -c %s damaged.journal) * 3 / 4)) conv=notrunc status=none
expect 1 damaged "$FLOES" merge first.h5 damaged.h5 third.h5 -o four.h5
said damaged "damaged.journal: "
said damaged "1 missing from all parts"

# Parts without -o do not get into each other's way.
expect 0 one "$FLOES" run campaign.toml --part 1/2 "${SHORT[@]}"
expect 0 other_one "$FLOES" run campaign.toml --part 2/2 --no-file "${SHORT[@]}"
said other_one "to write campaign.part2.h5, one core is enough: $FLOES run campaign.toml -o campaign.part2.h5 --resume --part 2/2 --set"
expect 0 both "$FLOES" merge campaign.part1.h5 campaign.part2.h5 -o campaign.h5
same whole.h5 campaign.h5

# In steps, of parts that are not kept; and again, where nothing is new.
expect 1 step "$FLOES" merge campaign.part1.h5 -o steps.h5
rm campaign.part1.*
expect 0 step "$FLOES" merge campaign.part2.h5 -o steps.h5
same whole.h5 steps.h5
expect 0 step "$FLOES" merge campaign.part2.h5 -o steps.h5 --keep-journal
same whole.h5 steps.h5
size=$(stat -c %s steps.journal)
expect 0 step "$FLOES" merge campaign.part2.h5 -o steps.h5 --keep-journal
[ "$size" = "$(stat -c %s steps.journal)" ] || fail "a merge added again what was there"
expect 0 again "$FLOES" run campaign.toml -o again.h5 --part 2/3 "${SHORT[@]}"
expect 1 twice "$FLOES" merge second.h5 again.h5 -o twice.h5
said twice "2 members of again.h5 are in second.h5 too, with the same results; they count once."

before=$(sha256sum three.h5)
expect 2 itself "$FLOES" merge first.h5 three.h5 -o three.h5 --overwrite
said itself "into itself"
expect 0 other "$FLOES" run campaign.toml -o other.h5 --part 4/4 "${SHORT[@]}" --set general.iterations=21
expect 2 mixed "$FLOES" merge first.h5 other.h5 -o three.h5 --overwrite
said mixed "general.iterations"
[ "$before" = "$(sha256sum three.h5)" ] || fail "a refused merge changed the files"
for part in 0/2 3/2 1/5 1 1/2x; do
    expect 2 "no_part" "$FLOES" run campaign.toml -o none.h5 --part "$part" "${SHORT[@]}"
done
