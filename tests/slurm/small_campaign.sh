# Sourced by tests that have $FOLDER, $FLOES and fail(): goes there, and makes a small campaign.
# shellcheck source=SCRIPTDIR/../support/channel.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/channel.sh"
cd "$FOLDER"

# 2 cases x 6 arrangements of two floes, a tenth of a second each: the time is the system's.
channel 2 "${ARRANGEMENTS:-6}" "${WINDOW:-12.0}" "${STEP:-0.02}" > campaign.toml

# said LOG TEXT: fails unless the log has the text.
said() {
    grep -qF -- "$2" "$1" || fail "$1 does not say '$2'"
}

# What the same program makes of the campaign without a batch system.
"$FLOES" run campaign.toml -o whole.h5 > /dev/null 2> whole.log || fail "the campaign does not run by itself"
