# A node dies with all that runs on it: the campaign goes back into the queue and completes on the nodes that are left.
export NODES="n1 n2 n3"
source "$(dirname "$0")/cluster.sh"
export HELD_FLOES=$FLOES
FLOES=$FLOES_HOME/tests/slurm/held_floes

# lose_node NAME: kills its slurmd, the steps, which write to the same log, and the processes of the jobs. An answer
# that the slurmd still gave may be read after that: ReturnToService=1 keeps a node down that a test has set down.
lose_node() {
    local pids
    mapfile -t pids < <(
        for pid in $(cluster_pids); do
            if [ -n "$(find "/proc/$pid/fd" -lname "$CLUSTER/log/slurmd-$1.log" 2> /dev/null)" ] ||
                env -u SLURM_CONF grep -qzsxF "SLURMD_NODENAME=$1" "/proc/$pid/environ"; then
                echo "$pid"
            fi
        done)
    [ ${#pids[@]} -gt 3 ] || fail "only ${#pids[@]} processes on $1"
    kill -KILL "${pids[@]}" 2> /dev/null || true
}

has_said() {
    grep -qF -- "$2" "$1"
}

# begin NAME: submits a campaign into NAME.h5 and waits until both ranks have fallen asleep.
begin() {
    job=$(HELD_JOURNAL=$FOLDER/$1.journal submit --nodes=2 --time=5 "$FLOES_HOME/slurm/campaign.sbatch" \
        campaign.toml -o "$1.h5")
    until_true 60 are_asleep "$job" || fail "job $job has no member after a minute"
}

# completes NAME NODES: the job does, on these nodes, and the file is that of an undisturbed campaign.
completes() {
    ends "$job" COMPLETED 60
    said "floes-$job.log" "start 2, on $2,"
    said "floes-$job.log" "resumed: "
    same whole.h5 "$1.h5"
}

# The node of a worker: mpirun notices, and the script asks Slurm for another start.
begin worker
lose_node n2
until_true 60 has_said "floes-$job.log" "and requeued" || fail "job $job did not go back into the queue"
# Slurm itself takes minutes to see it. Within cred_expire of the script's asking it would start the job at once, with a
# credential that it has just revoked.
sleep 7
scontrol update nodename=n2 state=down reason=lost
completes worker 'n[1,3]'

start_node n2
scontrol update nodename=n2 state=resume
until_true 30 all_idle || fail "node n2 did not come back"

# The node of the master and of the script itself: nobody is left to ask, and Slurm does it.
begin master
lose_node n1
scontrol update nodename=n1 state=down reason=lost
completes master 'n[2-3]'
