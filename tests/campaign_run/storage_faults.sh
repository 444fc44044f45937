# What a disk can do to a campaign: full, gone, used by another run. A sentence and a status, and --resume completes it.
source "$(dirname "$0")/common.sh"

expect 0 whole "$FLOES" run campaign.toml -o whole.h5 --keep-journal

# Full in the middle of the journal, a file size limit standing for the disk; then full while publishing.
size=$(($(stat -c %s whole.journal) / 1024))
expect 1 full bash -c 'ulimit -f "$0"; exec "$@"' "$((size * 3 / 4))" "$FLOES" run campaign.toml -o full.h5
said full "Is the disk full"
expect 0 full_resumed "$FLOES" run campaign.toml -o full.h5 --resume
said full_resumed "members reused"
said full_resumed " 0 set aside"
same whole.h5 full.h5

# The folder goes away during the run.
mkdir away
"$FLOES" run campaign.toml -o away/a.h5 > away.log 2>&1 &
wait_for_a_member away/a.journal
mv away moved
status=0
wait $! || status=$?
[ "$status" -eq 1 ] || fail "a run whose folder went away ended with $status"
said away "is gone: its folder was deleted, moved or replaced"
expect 0 moved "$FLOES" run campaign.toml -o moved/a.h5 --resume
same whole.h5 moved/a.h5

# Nowhere to write.
expect 2 nowhere "$FLOES" run campaign.toml -o /proc/a.h5
said nowhere "/proc/a.journal cannot be"

expect 2 no_folder "$FLOES" run campaign.toml -o no/such/a.h5
said no_folder "no/such/a.h5 cannot be written: there is no folder no/such; make the folder, or name another"
expect 2 no_replay "$FLOES" replay whole.h5 0 -o no/such/a.html
said no_replay "no/such/a.html cannot be written: there is no folder no/such; make the folder, or name another"

# Two runs into one file; and what a second terminal sees of the first.
"$FLOES" run campaign.toml -o two.h5 --threads 1 --set campaign.arrangements=12 > two.log 2>&1 &
first=$!
wait_for_a_member two.journal
expect 2 second "$FLOES" run campaign.toml -o two.h5 --resume --set campaign.arrangements=12
said second "is being written by another run"
expect 0 status "$FLOES" status two.h5
said status "Running: "
kill -9 "$first"
wait "$first" || true
expect 0 status "$FLOES" status two.h5 --watch
said status "continue it with floes run --resume"
expect 2 shrunk "$FLOES" run campaign.toml -o two.h5 --resume
said shrunk "campaign.arrangements: 12 there, 4 here"

# A campaign that grows equals one made at once.
expect 0 grown "$FLOES" run campaign.toml -o grown.h5 --set campaign.arrangements=2
expect 0 grown "$FLOES" run campaign.toml -o grown.h5 --resume
said grown "campaign.arrangements: 2 there, 4 here"
said grown "4 members reused, 4 computed, 0 retried, 0 set aside"
same whole.h5 grown.h5
