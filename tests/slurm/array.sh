# slurm/array.sbatch computes a campaign in parts without MPI, one of them stopped and requeued; slurm/merge.sbatch,
# which waits for all, makes the file of an undisturbed campaign.
source "$(dirname "$0")/cluster.sh"
PROGRAM=$FLOES

# The second part falls asleep after its first member, and is asked to stop.
held=$(HELD_FLOES=$PROGRAM HELD_JOURNAL=$FOLDER/campaign.part2.journal FLOES=$FLOES_HOME/tests/slurm/held_floes \
    submit --array=2 --cpus-per-task=1 --time=5 "$FLOES_HOME/slurm/array.sbatch" 3 campaign.toml)
others=$(submit --array=1,3 --cpus-per-task=1 --time=5 "$FLOES_HOME/slurm/array.sbatch" 3 campaign.toml)
merge=$(submit --dependency="afterany:$held:$others" "$FLOES_HOME/slurm/merge.sbatch" \
    campaign.h5 campaign.part{1,2,3}.h5)

is_asleep() {
    grep -qs "held: asleep" "floes-${held}_2.log"
}
until_true 60 is_asleep || fail "the second part has no member after a minute"
scancel --batch --signal=USR1 "$held"

ends "$merge" COMPLETED 90
said "floes-${held}_2.log" "part 2 of 3: 4 of these members"
said "floes-${held}_2.log" "ended with 85 and requeued"
said "floes-${held}_2.log" "resumed: "
said "floes-merge-$merge.log" "12 of 12 members done, 0 failed, 0 missing from all parts"
same whole.h5 campaign.h5

# What is no part of it is refused.
refused=$(submit --array=4 --cpus-per-task=1 "$FLOES_HOME/slurm/array.sbatch" 3 campaign.toml)
ends "$refused" FAILED 30
said "floes-${refused}_4.log" "--part 4/3 is not a part of this campaign"
