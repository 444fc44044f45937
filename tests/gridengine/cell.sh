# Sourced by the tests of Grid Engine: bash TEST.sh FLOES PROJECT. Starts a cell of one host with two slots on this machine
# that belongs to this test alone: own ports, own folder, no systemd, any user. Whatever happens to the test, the cell ends
# with it.
MARK_VARIABLE=SGE_ROOT
MARK_FILE=sge
source "$(dirname "${BASH_SOURCE[0]}")/../slurm/batch_system.sh"
export SGE_CELL=test SGE_ND=1  # ND: daemons do not leave their session
TOOLS=/usr/lib/gridengine

tell_system() {
    qstat
    cat "$SGE_ROOT"/spool/qmaster/messages "$SGE_ROOT"/spool/execd/*/messages
}

# The name by which Grid Engine knows this machine: that of the address 127.0.0.1, whatever uname says.
host_of_cell() {
    /usr/bin/python3 -c 'import socket; print(socket.gethostbyaddr("127.0.0.1")[0].split(".")[0])'
}

write_cell() {
    local common=$SGE_ROOT/$SGE_CELL/common name host=$1
    mkdir -p "$common" "$SGE_ROOT"/spool/{qmaster/job_scripts,execd}
    for name in bin lib utilbin util; do ln -s "/var/lib/gridengine/$name" "$SGE_ROOT/$name"; done
    echo "$host" > "$common/act_qmaster"
    [ "$host" = "$(uname -n)" ] || echo "$host $(uname -n)" > "$common/host_aliases"
    cat > "$common/bootstrap" <<CONF
admin_user              none
default_domain          none
ignore_fqdn             true
spooling_method         classic
spooling_lib            libspoolc
spooling_params         $common;$SGE_ROOT/spool/qmaster
binary_path             /usr/sbin
qmaster_spool_dir       $SGE_ROOT/spool/qmaster
security_mode           none
listener_threads        2
worker_threads          2
scheduler_threads       1
CONF
    sed -e "s|^execd_spool_dir.*|execd_spool_dir $SGE_ROOT/spool/execd|" -e 's|^min_uid.*|min_uid 0|' \
        -e 's|^min_gid.*|min_gid 0|' -e 's|^mailer.*|mailer /bin/true|' -e 's|^administrator_mail.*|administrator_mail none|' \
        -e 's|^load_report_time.*|load_report_time 00:00:02|' /usr/share/gridengine/default-configuration > "$CLUSTER/global"
    "$TOOLS/spoolinit" classic libspoolc "$common;$SGE_ROOT/spool/qmaster" init
    "$TOOLS/spooldefaults" configuration "$CLUSTER/global"
    "$TOOLS/spooldefaults" complexes /usr/share/gridengine/util/resources/centry
    "$TOOLS/spooldefaults" usersets /usr/share/gridengine/util/resources/usersets
    "$TOOLS/spooldefaults" managers "$(id -un)"
    "$TOOLS/spooldefaults" adminhosts "$host"
}

# A queue of two slots that schedules every second and gives a task five seconds after the signal of -notify.
write_queue() {
    local host=$1 limit
    qconf -ssconf | sed 's/^schedule_interval.*/schedule_interval 0:0:1/' > "$CLUSTER/scheduler"
    qconf -Msconf "$CLUSTER/scheduler"
    qconf -sq > "$CLUSTER/template"
    sed -e 's/^qname .*/qname test.q/' -e "s/^hostlist .*/hostlist $host/" -e 's/^slots .*/slots 2/' \
        -e 's/^notify .*/notify 00:00:05/' -e 's|^shell .*|shell /bin/bash|' -e 's/^load_thresholds .*/load_thresholds NONE/' \
        -e 's/^pe_list .*/pe_list NONE/' \
        "$CLUSTER/template" > "$CLUSTER/queue"
    qconf -as "$host"
    qconf -Aq "$CLUSTER/queue"
}

master_answers() {
    qconf -sconf > /dev/null 2>&1
}

host_is_up() {
    qstat -f 2> /dev/null | grep -q "^test.q@.* lx-"
}

start_cell() {
    local host ports
    for program in "$TOOLS/spoolinit" /usr/sbin/sge_qmaster /usr/sbin/sge_execd; do
        [ -x "$program" ] || fail "$program is missing; packages-test-all.txt has its package"
    done
    host=$(host_of_cell)
    read -ra ports < <(free_ports qmaster execd)
    export SGE_QMASTER_PORT=${ports[0]} SGE_EXECD_PORT=${ports[1]}
    write_cell "$host" > "$CLUSTER/log/cell.log" 2>&1 || fail "the cell of Grid Engine cannot be made; its log is above"
    as_daemon qmaster /usr/sbin/sge_qmaster
    until_true 30 master_answers || fail "sge_qmaster did not start; its log is above"
    write_queue "$host" > "$CLUSTER/log/queue.log" 2>&1 || fail "the queue cannot be made; its log is above"
    as_daemon execd /usr/sbin/sge_execd
    until_true 30 host_is_up || fail "sge_execd did not start; its log is above"
}

start_cell

# submit ARGUMENT…: prints the job's number.
submit() {
    qsub -terse "$@" 2> submit.log | cut -d. -f1 || fail "qsub refused: $*"
}

is_over() {
    ! qstat -j "$1" > /dev/null 2>&1
}

# ends JOB SECONDS: fails unless no task of it is left within the time.
ends() {
    until_true "$2" is_over "$1" || fail "job $1 has not ended after $2 s"
}

# running_tasks JOB: their numbers.
running_tasks() {
    qstat -s r 2> /dev/null | awk -v job="$1" '$1 == job && $5 ~ /r/ { print $NF }'
}
