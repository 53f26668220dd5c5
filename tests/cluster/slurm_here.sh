#!/bin/bash
# A chart in shares under a real Slurm: one controller and two virtual nodes of this machine, in a folder of its own.
#
#     slurm_here.sh PROGRAM
#
# The job script of `stridor chart --slurm` is submitted as it is printed. Of its array of four one task is requeued and
# one cancelled; the merge must name what is missing, the second round must complete it, and the chart must be that of a
# single run, byte for byte. Needs the packages slurm-wlm and munge, and root; without them it ends with 77: skipped.
set -u
program=$1

skip() {
    echo "skipped: $*"
    exit 77
}

PATH=$PATH:/usr/sbin:/sbin
for each in munged slurmctld slurmd sbatch squeue scancel scontrol; do
    command -v $each >/dev/null || skip "there is no $each here (packages slurm-wlm and munge)"
done
[ "$(id -u)" = 0 ] || skip "only root may start Slurm's daemons"

d=$(mktemp -d)
cd "$d" || exit 1

# our own daemons by their numbers, and nobody else's
end() {
    scancel --name=stridor-pair 2>/dev/null
    for _ in $(seq 100); do
        [ -n "$(squeue -h 2>/dev/null)" ] || break
        sleep 0.1
    done
    for each in "$d"/slurmd.n1.pid "$d"/slurmd.n2.pid "$d"/slurmctld.pid "$d"/munged.pid; do
        [ -s "$each" ] && kill "$(cat "$each")" 2>/dev/null
    done
    for _ in $(seq 50); do
        pgrep -F "$d/slurmctld.pid" >/dev/null 2>&1 || break
        sleep 0.1
    done
    rm -rf "$d"
}
trap end EXIT

fail() {
    echo "FAILED: $*"
    tail -n 30 "$d"/pair/slurm-*.log "$d"/slurm-*.out "$d"/*.log 2>/dev/null
    exit 1
}

# wait_for SECONDS COMMAND...: until it succeeds
wait_for() {
    local end=$((SECONDS + $1))
    shift
    until "$@"; do
        [ $SECONDS -lt $end ] || return 1
        sleep 0.1
    done
}

host=$(hostname -s)
port=$((20000 + $$ % 10000))
mkdir state spool.n1 spool.n2
dd if=/dev/urandom of=munge.key bs=1024 count=1 status=none
chmod 600 munge.key
# a requeued job may start once its credential is old: ten seconds instead of two minutes
cat >slurm.conf <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmctldPort=$port
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
AuthType=auth/munge
AuthInfo=socket=$d/munge.socket,cred_expire=10
CredType=cred/munge
StateSaveLocation=$d/state
SlurmdSpoolDir=$d/spool.%n
SlurmctldPidFile=$d/slurmctld.pid
SlurmdPidFile=$d/slurmd.%n.pid
SlurmctldLogFile=$d/slurmctld.log
SlurmdLogFile=$d/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SchedulerParameters=sched_min_interval=0,batch_sched_delay=0,sched_interval=2
KillWait=5
MinJobAge=300
ReturnToService=2
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1 RealMemory=500
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1 RealMemory=500
PartitionName=main Nodes=n1,n2 Default=YES State=UP
CONF
export SLURM_CONF=$d/slurm.conf
munged --force --key-file="$d/munge.key" --socket="$d/munge.socket" --pid-file="$d/munged.pid" \
    --log-file="$d/munged.log" --seed-file="$d/munged.seed" || skip "munged does not start here"
slurmctld -c -f slurm.conf || skip "slurmctld does not start here"
slurmd -f slurm.conf -N n1 || skip "slurmd does not start here"
slurmd -f slurm.conf -N n2 || skip "slurmd does not start here"
nodes_are_idle() { [ "$(sinfo -h -o %D -t idle 2>/dev/null)" = 2 ]; }
wait_for 20 nodes_are_idle || fail "the two nodes do not come up"
echo "[$SECONDS s] two virtual nodes are up"

# four blocks of runs, one for each task, of some seconds each: time enough to disturb them
"$program" init noise-chart -o pair.toml
chart=(chart pair.toml --set chart.x.points=64 --set chart.y.points=32 --set run.duration=0.06 --set run.window=0.03
    --set run.engine=beta_2 --set run.step=2e-6)
"$program" "${chart[@]}" --out pair --threads 1 --slurm 4 --time 2 >pair.slurm || fail "no script"
sbatch pair.slurm || fail "the script is refused"
task() { squeue -h -r -o '%F %K %T %j' | awk -v k="$1" '$2 == k { print $1, $3; exit }'; }
is_running() { [ "$(task "$1" | cut -d' ' -f2)" = RUNNING ]; }
is_begun() { is_running 0 && [ -e "$d/pair/shards/0000-of-0004.sqlite" ]; }
wait_for 20 is_begun || fail "the array does not begin"
array=$(task 0 | cut -d' ' -f1)
scontrol requeue "${array}_0" || fail "no requeue"
scancel "${array}_3" || fail "no cancel"
echo "[$SECONDS s] array $array: task 0 was requeued, task 3 cancelled"

first_merge_is_over() { grep -qs "round 2: " pair/slurm-*-merge.log; }
wait_for 120 first_merge_is_over || fail "no second round"
cat pair/slurm-*-merge.log
grep -q "3 of 4 shares, 1024 cells missing" pair/slurm-*-merge.log || fail "the merge does not count what is missing"
grep -q "  3/4: 1024 runs missing (not begun)" pair/slurm-*-merge.log || fail "the merge does not name what is missing"
echo "[$SECONDS s] the second round"
queue_is_empty() { [ -z "$(squeue -h)" ]; }
wait_for 120 queue_is_empty || fail "the second round does not end"
grep -q "complete; to draw it" pair/slurm-*-merge.log || fail "the second merge is not complete"
grep -q "stopped with" pair/slurm-"$array"-0.log || fail "the requeued task did not stop by itself"
grep -q "share 0/4 is done" pair/slurm-"$array"-0.log || fail "the requeued task did not go on"

"$program" "${chart[@]}" --out single --threads 2 >/dev/null 2>&1 || fail "no single run"
cmp pair/chart.csv single/chart.csv || fail "the chart is another one than that of a single run"
cmp pair/boundaries.csv single/boundaries.csv || fail "the boundaries are others than those of a single run"
echo "[$SECONDS s] complete, with the bytes of a single run"
