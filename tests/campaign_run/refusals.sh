# What floes run refuses, with which status, and that it then leaves everything as it was.
source "$(dirname "$0")/common.sh"

SMALL=(--set campaign.arrangements=1 --set analysis.window_s=3.0)

expect 2 no_file "$FLOES" run nowhere.toml
said no_file "nowhere.toml"
expect 2 told "$FLOES" run nowhere.toml --on-end 'echo "$FLOES_OUTCOME $FLOES_DONE: $FLOES_WORDS" > told.txt; exit 3'
[ "$(cat told.txt)" = "refused 0: floes run nowhere.toml: refused" ] || fail "--on-end was told '$(cat told.txt)'"
said told "ended with status 3"
expect 2 no_file_ranks "${MPIRUN[@]}" -n 2 "$FLOES" run nowhere.toml
expect 2 both "$FLOES" run campaign.toml --resume --overwrite
expect 2 threads "$FLOES" run campaign.toml --threads 0
expect 2 threads_ranks "${MPIRUN[@]}" -n 3 "$FLOES" run campaign.toml --threads 0
[ "$(grep -c -- "--threads" threads_ranks.log)" = "$(grep -c -- "--threads" threads.log)" ] ||
    fail "a wrong command line is reported by every rank"
expect 2 key "$FLOES" run campaign.toml --set ice.thicknes_m=0.03
said key "ice.thickness_m"
printf 'x_m,z_m,yaw_deg\n7,0,0\n7.5,0,0\n' > photo.csv
printf '[arrangement]\nmethod = "file"\nfile = "photo.csv"\n[field]\nfloes = 2\nconcentration_percent = 1\n[structure]\nspeed_m_s = 0.05\n' > photo.toml
expect 2 poses "$FLOES" run photo.toml -o campaign.h5
said poses "photo.csv, lines 2 and 3: floes 0 and 1"
expect 0 version "${MPIRUN[@]}" -n 2 "$FLOES" --version
said version "git_revision"
[ ! -e campaign.h5 ] && [ ! -e campaign.journal ] || fail "a refused run left a file"

expect 0 default_name "$FLOES" run campaign.toml "${SMALL[@]}"
[ -s campaign.h5 ] || fail "the campaign file is not named after the configuration"
before=$(sha256sum campaign.h5)
expect 2 exists "$FLOES" run campaign.toml "${SMALL[@]}"
said exists "--resume"
said exists "--overwrite"
expect 2 exists_ranks "${MPIRUN[@]}" -n 2 "$FLOES" run campaign.toml "${SMALL[@]}"
expect 2 other "$FLOES" run campaign.toml "${SMALL[@]}" --set general.iterations=21 --resume
said other "general.iterations"
[ "$before" = "$(sha256sum campaign.h5)" ] || fail "a refused run changed the files"
[ ! -e campaign.journal ] || fail "a refused run left a journal"
expect 0 overwritten "$FLOES" run campaign.toml "${SMALL[@]}" --set general.iterations=21 --overwrite

# Output that is not whole is an error; a reader that has read enough is none.
status=0
"$FLOES" summarize campaign.h5 --format csv > /dev/full 2> full.log || status=$?
[ "$status" = 1 ] || fail "summarize on a full disk ends with $status"
said full "standard output could not be written whole"
"$FLOES" summarize campaign.h5 --full | head -1 > first_line.txt

# A link to a running campaign's file is that campaign.
ln -s campaign.h5 link.h5
expect 2 link "$FLOES" run campaign.toml "${SMALL[@]}" -o link.h5
said link "campaign.h5"
[ -L link.h5 ] && [ ! -e link.journal ] || fail "a link is a campaign of its own"
