#!/bin/sh
# Charts on the ranks of an MPI job: mpi_test.sh MPIRUN STRIDOR STRIDOR_MPI
#
# The bytes of chart.csv are those of one process, for every number of ranks and threads, and however often the job, or
# one of its ranks, was killed or stopped. STRIDOR_MPI_KILLS=20 kills more often.
set -eu
mpirun=$1
stridor=$2
stridor_mpi=$3
kills=${STRIDOR_MPI_KILLS:-4}
# a test machine is a bare one, with few processors, where all is done by root
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

fail() {
    echo "FAILED: $*" >&2
    exit 1
}

# on_ranks RANKS ARGUMENTS...: what mpirun itself says goes to mpirun.txt
on_ranks() {
    ranks=$1
    shift
    "$mpirun" --oversubscribe --bind-to none -n "$ranks" "$stridor_mpi" "$@" </dev/null
}

"$stridor" init noise-chart -o pair.toml
small="--set chart.x.points=24 --set chart.y.points=20 --set run.duration=0.3 --set run.window=0.1"
plain="$small"
refined="$small --set chart.refine=2"
starts="$small --set chart.x.points=9 --set chart.starts=rest,sliding"

for kind in plain refined starts; do
    eval "options=\$$kind"
    "$stridor" chart pair.toml --out "$kind" --threads 2 $options >/dev/null 2>&1
done

echo "the same bytes for every number of ranks and threads"
for shape in "1 3 plain" "2 1 plain" "3 2 refined" "5 1 refined" "4 1 starts"; do
    set -- $shape
    eval "options=\$$3"
    on_ranks "$1" chart pair.toml --out "ranks-$1-$3" --threads "$2" $options >out.txt 2>err.txt ||
        fail "$1 ranks: $(cat err.txt)"
    for file in chart.csv boundaries.csv chart.nc chart.svg; do
        cmp "$3/$file" "ranks-$1-$3/$file" || fail "$file of $1 ranks with $2 threads differs"
    done
    [ "$(grep -c 'chart.csv' out.txt)" = 1 ] || fail "one rank alone speaks: $(cat out.txt)"
done

# long enough to be caught at work: some seconds
slow="--set chart.x.points=20 --set chart.y.points=20 --set chart.refine=2 --set run.early_ending=never
    --set run.duration=50 --set run.window=1"
"$stridor" chart pair.toml --out slow --threads 2 $slow >/dev/null 2>&1

echo "killed $kills times: ranks and mpirun itself"
kill_number=0
at_work=0 # kills that came before all was done
while [ "$kill_number" -lt "$kills" ]; do
    # done in spite of the kills: once more from the start
    [ ! -e killed/chart.csv ] || rm -r killed
    ranks=$((1 + kill_number % 5))
    # exec: the process is mpirun, not a shell
    (exec "$mpirun" --oversubscribe --bind-to none -n "$ranks" "$stridor_mpi" chart pair.toml --out killed --threads 1 \
        $slow </dev/null >out.txt 2>err.txt) &
    job=$!
    sleep "0.$((3 + 7 * kill_number % 6))"
    if [ $((kill_number % 2)) = 0 ]; then
        # the rank that was begun last; mpirun ends the others
        pkill -KILL -n -P "$job" 2>/dev/null || true
    else
        kill -KILL "$job" 2>/dev/null || true
    fi
    wait "$job" || true
    # ranks whose mpirun was killed end by themselves
    waited=0
    while pgrep -f "$folder" >/dev/null 2>&1 || pgrep -f "$stridor_mpi chart pair.toml --out killed" >/dev/null 2>&1; do
        waited=$((waited + 1))
        [ "$waited" -lt 200 ] || fail "ranks outlive their mpirun"
        sleep 0.1
    done
    [ -e killed/chart.csv ] || at_work=$((at_work + 1))
    kill_number=$((kill_number + 1))
done
[ "$at_work" -gt $((kills / 3)) ] || fail "only $at_work of $kills kills came while it was at work"
on_ranks 3 chart pair.toml --out killed --threads 1 $slow >out.txt 2>err.txt || fail "after the kills: $(cat err.txt)"
cmp slow/chart.csv killed/chart.csv || fail "chart.csv differs after $kills kills"

echo "stopped by signals"
for signal in TERM USR1; do
    (exec "$mpirun" --oversubscribe --bind-to none -n 2 "$stridor_mpi" chart pair.toml --out "on-$signal" --threads 1 \
        $slow </dev/null >out.txt 2>err.txt) &
    job=$!
    sleep 1.2
    kill -"$signal" "$job"
    wait "$job" && status=0 || status=$?
    grep -q 'all of them are kept' err.txt || fail "$signal (exit code $status): $(cat err.txt)"
    on_ranks 2 chart pair.toml --out "on-$signal" --threads 1 $slow >out.txt 2>err.txt || fail "$(cat err.txt)"
    cmp slow/chart.csv "on-$signal/chart.csv" || fail "chart.csv differs after $signal"
done

echo "what is wrong is said once, and by its exit code"
on_ranks 3 chart nothing.toml --out nothing >out.txt 2>err.txt && fail "a file that is not there was read"
[ "$(grep -c 'cannot read "nothing.toml"' err.txt)" = 1 ] || fail "$(cat err.txt)"
on_ranks 3 chart pair.toml --out plain --set run.duration=1 >out.txt 2>err.txt && fail "another study's store was taken"
[ "$(grep -c 'belongs to another study' err.txt)" = 1 ] || fail "$(cat err.txt)"
echo passed
