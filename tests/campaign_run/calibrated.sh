# Joints that follow Σ, and a case that gives an elastic modulus in place of it: calibrated once, the same on any ranks, kept for --resume, its curve
# in the file. Elements of 0.6 m, so that a plate test takes a tenth of a second.
source "$(dirname "$0")/common.sh"

sed -i 's/^elastic_modulus_MPa = 30.0/cfm = 0.03/' campaign.toml
SWEEPS=(--set general.solver=lanes --set joint.model=cfm --set water.added_mass_from=share)
COARSE=("${SWEEPS[@]}" --set floe.length_m=1.2 --set floe.element_m=0.6 --set field.floes=2 --set general.iterations=20
        --set campaign.arrangements=2 --set analysis.window_s=3.0)

expect 0 resolved "$FLOES" config --resolved campaign.toml "${COARSE[@]}"
said resolved "# joint.cfm: calibrated"
expect 0 alone "$FLOES" run campaign.toml -o alone.h5 "${COARSE[@]}"
said alone "calibrated E200: Σ = "
said alone "case E30: joint.cfm = 0.03 gives "
expect 0 ranks "${MPIRUN[@]}" -n 2 "$FLOES" run campaign.toml -o ranks.h5 "${COARSE[@]}"
same alone.h5 ranks.h5
expect 0 curve h5dump -d /calibration/elastic_modulus alone.h5

expect 0 again "$FLOES" run campaign.toml -o alone.h5 --resume "${COARSE[@]}"
said again "as before"
said again "alone.h5 has all of 4 members: nothing is left to compute"
same alone.h5 ranks.h5
expect 0 more "$FLOES" run campaign.toml -o alone.h5 --resume "${COARSE[@]}" --set campaign.arrangements=3
said more "as before"
said more "4 members reused, 2 to compute"
expect 0 ranks "$FLOES" run campaign.toml -o ranks.h5 --overwrite "${COARSE[@]}" --set campaign.arrangements=3
same alone.h5 ranks.h5

# A stop before the first member: nothing is there yet, and the same command begins again.
"$FLOES" run campaign.toml -o early.h5 "${SWEEPS[@]}" > early.log 2>&1 &
for _ in $(seq 3000); do grep -q "calibrating" early.log && break; sleep 0.02; done
kill -TERM $!
status=0
wait $! || status=$?
[ "$status" -eq 85 ] || fail "SIGTERM during the calibration ended with $status instead of 85"
[ ! -e early.journal ] || fail "a run that was stopped before its first member left a journal"

expect 2 another "$FLOES" run campaign.toml -o alone.h5 --resume "${COARSE[@]}" --set case.E200.elastic_modulus_MPa=150
said another "elastic_modulus_MPa"
expect 2 ceiling "$FLOES" run campaign.toml -o ceiling.h5 "${COARSE[@]}" --set case.E200.elastic_modulus_MPa=50000
said ceiling "case E200 cannot be calibrated"
[ ! -e ceiling.h5 ] && [ ! -e ceiling.journal ] || fail "a refused run left a file"
expect 2 exists "$FLOES" run campaign.toml -o alone.h5 "${COARSE[@]}"
! grep -q "calibrating" exists.log || fail "calibrated before it refused to overwrite"
