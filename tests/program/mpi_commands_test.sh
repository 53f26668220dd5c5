#!/bin/sh
# Advice, evaluations and diagrams on the ranks of an MPI job: mpi_commands_test.sh MPIRUN STRIDOR STRIDOR_MPI
#
# What they print and write is that of one process, and who does not belong to the job is named.
set -eu
mpirun=$1
stridor=$2
stridor_mpi=$3
# a test machine is a bare one, with few processors, where all is done by root
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export XDG_CACHE_HOME="$folder/cache"

fail() {
    echo "FAILED: $*" >&2
    exit 1
}

# on_ranks RANKS ARGUMENTS...
on_ranks() {
    ranks=$1
    shift
    "$mpirun" --oversubscribe --bind-to none -n "$ranks" "$stridor_mpi" "$@" </dev/null
}

"$stridor" init squeal -o squeal.toml
"$stridor" init noise-chart -o pair.toml

echo "advice"
advice="squeal.toml --over preload --over mu_d --tolerance mu_d=0.05 --samples 100 --json"
"$stridor" advise $advice >one.json 2>/dev/null
for shape in "1 2" "3 1" "2 2"; do
    set -- $shape
    on_ranks "$1" advise $advice --threads "$2" >ranks.json 2>err.txt || fail "advice of $1 ranks: $(cat err.txt)"
    cmp one.json ranks.json || fail "the advice of $1 ranks with $2 threads differs"
done

echo "an evaluation of two charts"
small="--set chart.x.points=6 --set chart.y.points=5 --set chart.refine=0 --set run.duration=0.5 --set run.window=0.3"
"$stridor" init noise-chart -o other.toml
sed -i 's/^static_friction .*/static_friction = 0.9/' other.toml
evaluation="pair.toml other.toml $small --perturb-every 5 --json"
"$stridor" evaluate $evaluation --csv one.csv >one.json 2>/dev/null
on_ranks 3 evaluate $evaluation --csv ranks.csv --threads 1 >ranks.json 2>err.txt || fail "$(cat err.txt)"
cmp one.json ranks.json || fail "the evaluation of 3 ranks differs"
cmp one.csv ranks.csv || fail "the table of 3 ranks differs"
[ -z "$(ls cache/stridor)" ] || fail "something is kept of what is done: $(ls cache/stridor)"

echo "an evaluation that is stopped goes on"
slow="pair.toml other.toml $small --set run.duration=40 --set run.window=1 --set run.early_ending=never"
"$stridor" evaluate $slow --json >one.json 2>/dev/null
rm -rf cache
# mpirun passes SIGUSR1 on; after SIGTERM it would kill within a second, too soon on a busy machine
"$mpirun" --oversubscribe --bind-to none -n 2 "$stridor_mpi" evaluate $slow --json \
    >stopped.json 2>stopped.txt </dev/null &
job=$!
tries=0
until grep -q "[1-9]/60 cells" stopped.txt 2>/dev/null || [ "$tries" -gt 600 ]; do
    tries=$((tries + 1))
    sleep 0.1
done
kill -USR1 "$job"
wait "$job" && fail "it was not stopped"
grep -q "stopped in" stopped.txt || fail "it does not say that it was stopped: $(cat stopped.txt)"
on_ranks 3 evaluate $slow --json >ranks.json 2>err.txt || fail "$(cat err.txt)"
grep -q "goes on from" err.txt || fail "it does not go on: $(cat err.txt)"
cmp one.json ranks.json || fail "the evaluation that went on differs"

echo "a diagram"
line="--x mu_d=0.2:0.7:24"
"$stridor" chart squeal.toml $line --out one >/dev/null 2>&1
on_ranks 3 chart squeal.toml $line --out ranks >/dev/null 2>err.txt || fail "$(cat err.txt)"
cmp one/diagram.csv ranks/diagram.csv || fail "the diagram of 3 ranks differs"
# all is kept: ranks without work
on_ranks 2 chart squeal.toml $line --out ranks >/dev/null 2>err.txt || fail "$(cat err.txt)"
cmp one/diagram.csv ranks/diagram.csv || fail "the diagram that was kept differs"

echo "a rank with another case is named"
if "$mpirun" --oversubscribe --bind-to none -n 1 "$stridor_mpi" advise $advice : \
    -n 1 "$stridor_mpi" advise $advice --set contact.preload=11 </dev/null >out.txt 2>err.txt; then
    fail "two cases in one job were not refused"
fi
grep -q "rank 1 on .* reads another case or chart" err.txt || fail "it is not named: $(cat err.txt)"
echo "passed"
