#!/usr/bin/env bash
# The program on an emulated processor without AVX (Nehalem, the first of x86-64-v2): the same members as on this one.
#   old_processor.sh PROGRAM MPIEXEC
# shellcheck source=SCRIPTDIR/../campaign_run/common.sh
source "$(dirname "$0")/../campaign_run/common.sh"

expect 0 version qemu-x86_64 -cpu Nehalem "$FLOES" --version
grep -qx 'lane_widths: 1, 2' version.log || fail "it says $(grep lane_widths version.log)"
small=(--threads 1 --set campaign.arrangements=1 --set analysis.steady_start_s=1.0 --set analysis.window_s=3.0)
expect 0 old qemu-x86_64 -cpu Nehalem "$FLOES" run campaign.toml -o old.h5 "${small[@]}"
expect 0 new "$FLOES" run campaign.toml -o new.h5 "${small[@]}"
same old.h5 new.h5
