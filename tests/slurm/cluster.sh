# Sourced by the tests of slurm/: bash TEST.sh FLOES PROJECT. Starts a Slurm cluster of two nodes on this machine that
# belongs to this test alone: own munge, own ports, own folder, no systemd, any user. Whatever happens to the test, the
# cluster ends with it.
MARK_VARIABLE=SLURM_CONF
MARK_FILE=slurm.conf
source "$(dirname "${BASH_SOURCE[0]}")/batch_system.sh"
NODES=${NODES:-n1 n2}
# Two ranks of one machine on two nodes of Slurm: shared memory would mix up their names, and a container may have no
# network but this one. Root is all there is in a container.
export OMPI_MCA_btl=self,tcp OMPI_MCA_btl_tcp_if_include=lo OMPI_MCA_oob_tcp_if_include=lo
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

tell_system() {
    scontrol show jobs
}

start_munge() {
    local folder=$CLUSTER/munge
    head -c 1024 /dev/urandom > "$folder/key"
    chmod 400 "$folder/key"
    as_daemon munged munged --foreground --force --num-threads=2 --key-file="$folder/key" --socket="$folder/socket" \
        --pid-file="$folder/pid" --log-file="$CLUSTER/log/munged.log" --seed-file="$folder/seed"
    until_true 20 test -S "$folder/socket" || fail "munged, which Slurm needs, did not start; its log is above"
}

write_configuration() {
    local host user ports node
    host=$(uname -n)  # hostname -s asks a resolver, which a container may lack
    host=${host%%.*}
    user=$(id -un)
    # shellcheck disable=SC2086
    read -ra ports < <(free_ports controller $NODES)
    cat > "$SLURM_CONF" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=${ports[0]}
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$CLUSTER/munge/socket,cred_expire=5
StateSaveLocation=$CLUSTER/state
SlurmctldPidFile=$CLUSTER/run/slurmctld.pid
SlurmctldLogFile=$CLUSTER/log/slurmctld.log
SlurmdSpoolDir=$CLUSTER/spool/%n
SlurmdPidFile=$CLUSTER/run/slurmd-%n.pid
SlurmdLogFile=$CLUSTER/log/slurmd-%n.log
TmpFS=$CLUSTER/tmp/%n
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/filetxt
JobCompLoc=$CLUSTER/log/jobcomp.txt
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/backfill
SchedulerParameters=bf_interval=2,sched_interval=2,batch_sched_delay=0
SlurmdParameters=config_overrides
MpiDefault=pmix
MailProg=/bin/true
ReturnToService=1
SlurmctldTimeout=30
SlurmdTimeout=30
InactiveLimit=0
KillWait=5
MinJobAge=300
JobRequeue=1
PartitionName=debug Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
    # No limits are asked for; cgroup/v2 would want systemd all the same.
    echo "CgroupPlugin=cgroup/v1" > "$CLUSTER/cgroup.conf"
    # Without an address beside 127.0.0.1, Slurm does not even resolve that one as long as it is for IPv4 alone.
    [ -n "$(hostname -I 2> /dev/null)" ] || echo "CommunicationParameters=EnableIPv6" >> "$SLURM_CONF"
    for node in $NODES; do
        echo "NodeName=$node NodeHostname=$host NodeAddr=127.0.0.1 Port=${ports[1]} CPUs=2 State=UNKNOWN"
        ports=("${ports[@]:1}")
    done >> "$SLURM_CONF"
}

start_node() {
    mkdir -p "$CLUSTER"/{spool,tmp}/"$1"
    as_daemon "slurmd-$1" slurmd -D -f "$SLURM_CONF" -N "$1"
}

controller_answers() {
    scontrol ping 2> /dev/null | grep -q ' is UP'
}

all_idle() {
    [ "$(sinfo -h -o %T)" = idle ]
}

start_cluster() {
    local program node
    for program in munged slurmctld slurmd sbatch; do
        PATH=$PATH:/usr/sbin command -v "$program" > /dev/null || fail "$program is missing; packages-test-all.txt has it"
    done
    PATH=$PATH:/usr/sbin
    mkdir -p "$CLUSTER/munge"
    chmod 755 "$CLUSTER" "$CLUSTER/munge"
    start_munge
    write_configuration
    # shellcheck disable=SC2034  # a test asks
    CONTROLLER_START=$SECONDS
    as_daemon slurmctld slurmctld -D -f "$SLURM_CONF"
    until_true 20 controller_answers || fail "slurmctld did not start; its log is above"
    for node in $NODES; do start_node "$node"; done
    until_true 30 all_idle || fail "the nodes of Slurm did not come up; their logs are above"
}

start_cluster

# submit ARGUMENT…: prints the job's number.
submit() {
    sbatch --parsable "$@" 2> submit.log || fail "sbatch refused: $*"
}

# state_of JOB
state_of() {
    scontrol show job "$1" | sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p' | sort -u
}

has_state() {
    [ "$(state_of "$1")" = "$2" ]
}

# ends JOB STATE SECONDS: fails unless it comes to that end within the time.
ends() {
    until_true "$3" has_state "$1" "$2" || fail "job $1 is $(state_of "$1") instead of $2 after $3 s"
}

is_over() {
    [ -z "$(squeue -h -j "$1" 2> /dev/null)" ]
}

# are_asleep JOB: both of its ranks, of held_floes.
are_asleep() {
    [ "$(grep -cs "held: asleep" "floes-$1.log")" = 2 ]
}
