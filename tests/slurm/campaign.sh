# slurm/campaign.sbatch and slurm/smoke.sbatch over two nodes, to the end.
source "$(dirname "$0")/cluster.sh"

job=$(submit --nodes=2 --time=5 "$FLOES_HOME/slurm/campaign.sbatch" campaign.toml -o campaign.h5)
ends "$job" COMPLETED 60
said "floes-$job.log" "of 2 ranks"
said "floes-$job.log" "8 of 8 done, 0 failed"
same whole.h5 campaign.h5
