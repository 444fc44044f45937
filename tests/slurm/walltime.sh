# The signal before the time limit: the campaign publishes, goes back into the queue, and completes.
source "$(dirname "$0")/cluster.sh"
export HELD_FLOES=$FLOES HELD_JOURNAL=$FOLDER/campaign.journal
FLOES=$FLOES_HOME/tests/slurm/held_floes

# Slurm gives the signal up to a minute early: at its next look at the limits, one every half a minute. The campaign
# must have begun by then, also on a slow machine.
phase=$(((SECONDS - CONTROLLER_START) % 30))
[ "$phase" -lt 12 ] || sleep $((31 - phase))
job=$(submit --nodes=2 --time=1 --signal=B:USR1@30 "$FLOES_HOME/slurm/campaign.sbatch" campaign.toml -o campaign.h5)
ends "$job" COMPLETED 90
said "floes-$job.log" "held: asleep"
said "floes-$job.log" "stopped by "  # SIGUSR1, or a signal to rank 1, whichever rank mpirun tells first
said "floes-$job.log" "ended with 85 and requeued, restart 1 of at most 100"
said "floes-$job.log" "resumed: "
said "floes-$job.log" "12 of 12 done, 0 failed"
same whole.h5 campaign.h5
