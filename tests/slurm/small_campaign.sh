# Sourced by tests that have $FOLDER, $FLOES and fail(): goes there, and makes a small campaign.
cd "$FOLDER"

# campaign.toml: 2 cases x 6 arrangements of two floes, a tenth of a second each: the time is the system's.
cat > campaign.toml <<TOML
[campaign]
seed = 1
arrangements = ${ARRANGEMENTS:-6}

[general]
time_step_s = ${STEP:-0.02}

[field]
floes = 2
concentration_percent = 40.0
begin_m = 2.0
half_width_m = 1.25

[structure]
profile_m = [[-0.443, 0.43], [0.0, 0.614], [0.122, 0.736]]
start_m = 1.38
speed_m_s = 0.03

[analysis]
steady_start_s = 2.0
window_s = ${WINDOW:-12.0}

[[case]]
name = "E30"
elastic_modulus_MPa = 30.0

[[case]]
name = "E200"
elastic_modulus_MPa = 200.0
TOML

# same A.h5 B.h5: fails unless both files have the same values outside /provenance.
same() {
    h5diff --exclude-path /provenance "$1" "$2" > difference.log 2>&1 || fail "$1 and $2 differ"
}

# said LOG TEXT: fails unless the log has the text.
said() {
    grep -qF -- "$2" "$1" || fail "$1 does not say '$2'"
}

# What the same program makes of the campaign without a batch system.
"$FLOES" run campaign.toml -o whole.h5 > /dev/null 2> whole.log || fail "the campaign does not run by itself"
