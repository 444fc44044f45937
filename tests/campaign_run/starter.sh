# What floes new writes for a first campaign runs, within a minute of two cores (a quarter of it here), and gives the file
# that it says.
source "$(dirname "$0")/common.sh"

expect 0 new "$FLOES" new my.toml
said new "floes run my.toml"
expect 0 run "$FLOES" run my.toml --set campaign.arrangements=1
times > times.txt  # of processors, which a busy machine hardly changes; line 2 is that of what the shell started
read -r user _ < <(tail -n 1 times.txt)
user=$(awk -F '[ms]' '{ print int(60 * $1 + $2) }' <<< "$user")
[ "$user" -le 30 ] || fail "the first campaign took $user s of a processor"
expect 0 summarized "$FLOES" summarize my.h5
said summarized "thin"
said summarized "thick"
for member in 0 1; do
    load=$(h5dump -y -d /members/mean_load -s "$member" -c 1 my.h5 | sed -n 's/^ *\([0-9.e-]*\)$/\1/p' | head -n 1)
    [ "$(echo "$load" | awk '{ print ($1 > 0.5) }')" = 1 ] || fail "the ice hardly touched the hull in member $member: $load N"
done
