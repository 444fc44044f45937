# slurm/campaign.sbatch over two nodes, to the end; and cancelled, which is no reason to go back into the queue.
source "$(dirname "$0")/cluster.sh"

job=$(submit --nodes=2 --time=5 "$FLOES_HOME/slurm/campaign.sbatch" campaign.toml -o campaign.h5)
ends "$job" COMPLETED 60
said "floes-$job.log" "of 2 ranks"
said "floes-$job.log" "12 of 12 done, 0 failed"
same whole.h5 campaign.h5

export HELD_FLOES=$FLOES HELD_JOURNAL=$FOLDER/cancelled.journal
job=$(FLOES=$FLOES_HOME/tests/slurm/held_floes submit --nodes=2 --time=5 "$FLOES_HOME/slurm/campaign.sbatch" \
    campaign.toml -o cancelled.h5)
until_true 60 are_asleep "$job" || fail "job $job has no member after a minute"
scancel "$job"
until_true 30 is_over "$job" || fail "job $job is still in the queue"
ends "$job" CANCELLED 1
said "floes-$job.log" "cancelled; the same sbatch command resumes"
