# Sourced by tests of whole campaigns that have fail().

# channel FLOES ARRANGEMENTS WINDOW [STEP]: prints a configuration of two cases; of two or four floes and 12 to 24 s a
# member takes some tenths of a second at most.
channel() {
    cat <<TOML
[campaign]
seed = 1
arrangements = $2

[general]
time_step_s = ${4:-0.02}

[field]
floes = $1
concentration_percent = 40.0
begin_m = 2.0
half_width_m = 1.25

[structure]
profile_m = [[-0.443, 0.43], [0.0, 0.614], [0.122, 0.736]]
start_m = 1.38
speed_m_s = 0.03

[analysis]
steady_start_s = 2.0
window_s = $3

[[case]]
name = "E30"
elastic_modulus_MPa = 30.0

[[case]]
name = "E200"
elastic_modulus_MPa = 200.0
TOML
}

# same A.h5 B.h5: fails unless both files have the same values outside /provenance.
same() {
    h5diff --exclude-path /provenance "$1" "$2" > difference.log 2>&1 || fail "$1 and $2 differ"
}
