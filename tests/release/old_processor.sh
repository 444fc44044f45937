#!/usr/bin/env bash
# The program on an emulated processor without AVX (Nehalem, the first of x86-64-v2): the same member as on this one.
#   old_processor.sh PROGRAM
set -euo pipefail
program=$1
stage=$(mktemp -d)
trap 'rm -rf -- "$stage"' EXIT
cd "$stage"
fail() { echo "FAILED: $*" >&2; exit 1; }

cat >tiny.toml <<'TOML'
[campaign]
seed = 1
arrangements = 1

[field]
floes = 4
concentration_percent = 40.0
begin_m = 2.0
half_width_m = 1.25

[structure]
profile_m = [[-0.443, 0.43], [0.0, 0.614], [0.122, 0.736]]
start_m = 1.38
speed_m_s = 0.03

[analysis]
steady_start_s = 1.0
window_s = 3.0

[[case]]
name = "E30"
elastic_modulus_MPa = 30.0
cfm = 0.03
TOML

old() { qemu-x86_64 -cpu Nehalem "$program" "$@"; }
old --version >version || fail "the program does not start"
grep -qx 'lane_widths: 1, 2' version || fail "it says $(grep lane_widths version)"
old run tiny.toml -o old.h5 --threads 1 >log 2>&1 || fail "$(<log)"
"$program" run tiny.toml -o new.h5 >log 2>&1 || fail "$(<log)"
h5diff --exclude-path /provenance old.h5 new.h5 >log || fail "the members differ: $(<log)"
echo "the same member on $(grep lane_widths version) and on $("$program" --version | grep lane_widths)"
