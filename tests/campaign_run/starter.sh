# What floes new writes for a first campaign runs, within a minute on two cores, and gives the file that it says.
source "$(dirname "$0")/common.sh"

expect 0 new "$FLOES" new my.toml
said new "floes run my.toml"
before=$SECONDS
expect 0 run "$FLOES" run my.toml
[ $((SECONDS - before)) -le 180 ] || fail "the first campaign took $((SECONDS - before)) s"
expect 0 summarized "$FLOES" summarize my.h5
said summarized "thin"
said summarized "thick"
for member in 0 1 2 3 4 5 6 7; do
    load=$(h5dump -y -d /members/mean_load -s "$member" -c 1 my.h5 | sed -n 's/^ *\([0-9.e-]*\)$/\1/p' | head -n 1)
    [ "$(echo "$load" | awk '{ print ($1 > 0.5) }')" = 1 ] || fail "the ice hardly touched the hull in member $member: $load N"
done
