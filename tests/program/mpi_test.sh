#!/bin/sh
# Charts on the ranks of an MPI job: mpi_test.sh MPIRUN STRIDOR STRIDOR_MPI
#
# The bytes of every file are those of one process, for every number of ranks and threads, and however often the job, or
# one of its ranks, was killed or stopped at random. STRIDOR_MPI_KILLS=20 does so twenty times to each kind of chart,
# STRIDOR_MPI_SEED=2 at other moments.
set -eu
mpirun=$1
stridor=$2
stridor_mpi=$3
kills=${STRIDOR_MPI_KILLS:-1}
seed=${STRIDOR_MPI_SEED:-1}
# a test machine is a bare one, with few processors, where all is done by root
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

fail() {
    echo "FAILED: $*" >&2
    exit 1
}

# random COUNT: sets `drawn`, at least 0 and below COUNT
random() {
    seed=$(((seed * 1103515245 + 12345) % 2147483648))
    drawn=$((seed / 65536 % $1))
}

# on_ranks RANKS ARGUMENTS...
on_ranks() {
    ranks=$1
    shift
    "$mpirun" --oversubscribe --bind-to none -n "$ranks" "$stridor_mpi" "$@" </dev/null
}

# begin RANKS ARGUMENTS...: the same beside the test; what mpirun itself says goes to err.txt
begin() {
    ranks=$1
    shift
    # exec: the process is mpirun, not a shell
    (exec "$mpirun" --oversubscribe --bind-to none -n "$ranks" "$stridor_mpi" "$@" </dev/null >out.txt 2>err.txt) &
    job=$!
}

# same WHOLE OTHER WHEN: the folders hold the same, but for the stores
same() {
    diff -r -q -x chart.sqlite "$1" "$2" >differences.txt || fail "$3: $(cat differences.txt)"
}

# one_rank COUNT: a random one of the job's first ranks; mpirun itself where they are not there yet
one_rank() {
    random "$1"
    victim=$(pgrep -P "$job" | sort -n | sed -n "$((1 + drawn))p")
    [ -n "$victim" ] || victim=$job
}

# waits for the job, and for ranks whose mpirun was killed: they end by themselves
wait_for_end() {
    wait "$job" && status=0 || status=$?
    waited=0
    while pgrep -f "$folder" >/dev/null 2>&1; do
        waited=$((waited + 1))
        [ "$waited" -lt 200 ] || fail "ranks outlive their mpirun"
        sleep 0.1
    done
}

"$stridor" init noise-chart -o pair.toml

echo "the same bytes for every number of ranks and threads"
small="--set chart.x.points=24 --set chart.y.points=20 --set run.duration=0.3 --set run.window=0.1"
plain="$small"
refined="$small --set chart.refine=2"
starts="$small --set chart.x.points=9 --set chart.starts=rest,sliding"
for kind in plain refined starts; do
    eval "options=\$$kind"
    "$stridor" chart pair.toml --out "$kind" --threads 2 $options >/dev/null 2>&1
done
for shape in "1 3 plain" "2 1 plain" "3 2 refined" "5 1 refined" "4 1 starts"; do
    set -- $shape
    eval "options=\$$3"
    on_ranks "$1" chart pair.toml --out "ranks-$1-$3" --threads "$2" $options >out.txt 2>err.txt ||
        fail "$1 ranks: $(cat err.txt)"
    same "$3" "ranks-$1-$3" "$1 ranks with $2 threads"
    [ "$(grep -c 'chart.csv' out.txt)" = 1 ] || fail "one rank alone speaks: $(cat out.txt)"
done

# long enough to be caught at work: cells of some 10 ms, two seconds of them
all_files="--files png,svg,pdf,csv,boundaries,nc,zarr"
slow="--set run.early_ending=never --set run.duration=25 --set run.window=1"
slow_plain="$slow --set chart.x.points=12 --set chart.y.points=9"
slow_refined="$slow --set chart.x.points=15 --set chart.y.points=11 --set chart.refine=2"
slow_starts="$slow --set chart.x.points=9 --set chart.y.points=6 --set chart.starts=rest,sliding"

# killed_once OPTIONS...: a chart on ranks, killed at a random moment in a random way
killed_once() {
    random 5 && ranks=$((1 + drawn))
    random 3 && threads=$((1 + drawn))
    # how long mpirun waits before it kills what has not ended [s]
    random 2 && export OMPI_MCA_odls_base_sigkill_timeout="$drawn"
    begin "$ranks" chart pair.toml --out "$out" --threads "$threads" "$@"
    random 8
    sleep "0.$((drawn + 2))"
    random 4
    case $drawn in
        0) one_rank "$ranks" && signal=KILL ;;
        1) victim=$job && signal=KILL ;;
        2) one_rank 1 && signal=TERM ;; # the others leave it to rank 0
        3) victim=$job && signal=TERM ;;
    esac
    kill -"$signal" "$victim" 2>/dev/null || true
    wait_for_end
    unset OMPI_MCA_odls_base_sigkill_timeout
    kill_number=$((kill_number + 1))
}

# killed KIND OPTIONS...: again and again, each time resumed on another count
killed() {
    whole=$1
    shift
    "$stridor" chart pair.toml --out "$whole" --threads 2 $all_files "$@" >/dev/null 2>&1
    out="$folder/killed-$whole"
    kill_number=0
    while [ "$kill_number" -lt "$kills" ]; do
        killed_once $all_files "$@"
        [ -e "$out/chart.csv" ] || at_work=$((at_work + 1))
        [ "$status" = 0 ] || continue
        # done in spite of the kills: once more from the start
        same "$whole" "$out" "after $kill_number kills"
        rm -r "$out"
    done
    random 5
    on_ranks $((1 + drawn)) chart pair.toml --out "$out" --threads 1 $all_files "$@" >out.txt 2>err.txt ||
        fail "after the kills: $(cat err.txt)"
    same "$whole" "$out" "after $kills kills"
}

# killed_shares KIND OPTIONS...: the same for two shares of a chart that is there, merged in the end
killed_shares() {
    whole=$1
    shift
    out="$folder/killed-shares"
    kill_number=0
    while [ "$kill_number" -lt "$kills" ]; do
        random 2
        killed_once --shard "$drawn/2" "$@"
        grep -q "is done" out.txt || at_work=$((at_work + 1))
    done
    for share in 1/2 0/2; do
        random 5
        on_ranks $((1 + drawn)) chart pair.toml --out "$out" --threads 1 --shard "$share" "$@" >out.txt 2>err.txt ||
            fail "share $share after the kills: $(cat err.txt)"
    done
    "$stridor" merge "$out" >out.txt 2>err.txt || fail "after the kills: $(cat err.txt)"
    rm -r "$out/shards"
    "$stridor" chart pair.toml --out "$out" $all_files "$@" >/dev/null 2>&1
    same "$whole" "$out" "merged of two shares, after $kills kills"
}

echo "killed $kills time(s) each: ranks and mpirun itself, by SIGKILL and SIGTERM"
at_work=0 # kills that came before all was done
killed slow_plain $slow_plain
killed slow_refined $slow_refined
killed slow_starts $slow_starts
killed_shares slow_plain $slow_plain
echo "$at_work of $((4 * kills)) kills came while it was at work"
[ "$at_work" -ge "$kills" ] || fail "too few"

# notes_signals PROCESS: whether it runs the program, and SIGUSR1 is caught or left to rank 0: the tenth signal is the
# second bit of the third digit
notes_signals() {
    [ "$(readlink "/proc/$1/exe")" = "$(readlink -f "$stridor_mpi")" ] &&
        grep -q '^Sig\(Cgt\|Ign\):.*[2367abef]..$' "/proc/$1/status" 2>/dev/null
}

# until both ranks of the job note signals
wait_for_noting() {
    noting=0
    while [ "$noting" -lt 2 ] && kill -0 "$job" 2>/dev/null; do
        noting=0
        for rank in $(pgrep -P "$job"); do
            notes_signals "$rank" && noting=$((noting + 1))
        done
    done
}

echo "stopped by signals, and nothing is lost"
out="$folder/signalled"
for signal in TERM USR1; do
    # it would take a minute
    begin 2 chart pair.toml --out "$out" --threads 1 $slow_plain --set run.duration=400
    wait_for_noting
    sleep 0.5
    kill -"$signal" "$job"
    wait_for_end
    kept=$(sed -n 's/^.*stopped with \([0-9]*\) of .*all of them are kept in .*$/\1/p' err.txt)
    [ -n "$kept" ] || fail "$signal (exit code $status): $(cat err.txt)"
    "$stridor" chart-status "$out" >status.txt || true
    grep -q "^$kept of " status.txt || fail "$kept cells were to be kept: $(cat status.txt)"
done

# begin_signalled: a job of two ranks gets SIGUSR1 once both note signals; sets `early`: whether it had no store by then
begin_signalled() {
    rm -rf "$out"
    begin 2 chart pair.toml --out "$out" --threads 1 $slow_plain --set run.duration=400
    wait_for_noting
    [ -e "$out/chart.sqlite" ] && early=no || early=yes
    kill -USR1 "$job"
}

echo "stopped by a signal that comes while MPI begins"
out="$folder/early"
early=no
tries=0
# a busy machine may look too late
while [ "$early" = no ]; do
    tries=$((tries + 1))
    [ "$tries" -le 20 ] || fail "signals are noted only when the store is open"
    begin_signalled
    wait_for_end
    grep -q 'stopped with [0-9]* of ' err.txt || fail "USR1 (exit code $status): $(cat err.txt)"
done

echo "what is wrong is said once, and by its exit code"
on_ranks 3 chart nothing.toml --out nothing >out.txt 2>err.txt && fail "a file that is not there was read"
[ "$(grep -c 'cannot read "nothing.toml"' err.txt)" = 1 ] || fail "$(cat err.txt)"
on_ranks 3 chart pair.toml --out plain --set run.duration=1 >out.txt 2>err.txt && fail "another study's store was taken"
[ "$(grep -c 'belongs to another study' err.txt)" = 1 ] || fail "$(cat err.txt)"
echo passed
