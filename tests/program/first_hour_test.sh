#!/bin/sh
# What a new user types in the first hour, right and wrong: each step ends with its exit code and says what it must.
# usage: first_hour_test.sh PROGRAM
set -u
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
mkdir bin && ln -s "$program" bin/stridor
PATH=$folder/bin:$PATH
HOME=$folder XDG_DATA_HOME=$folder/data XDG_CACHE_HOME=$folder/cache NO_COLOR=1 LC_ALL=C.UTF-8 COLUMNS=100
export PATH HOME XDG_DATA_HOME XDG_CACHE_HOME NO_COLOR LC_ALL COLUMNS
steps=0
failures=0

fail() {
    failures=$((failures + 1))
    echo "step $steps: $1"
    sed 's/^/    /' out | cut -c 1-200 | head -n 12
}

# step CODE COMMAND: the words of a shell, run with nothing to read; what it says lies in `out`
step() {
    steps=$((steps + 1))
    command=$2
    sh -c "$2" > out 2>&1 < /dev/null
    code=$?
    [ "$code" -eq "$1" ] || fail "$2: exit code $code instead of $1"
    # whatever happens, no line is a wall and nothing is a number of hundreds of digits
    if grep -q '[0-9]\{60\}' out; then fail "$2: prints an endless number"; fi
}

# what the last step must say, and what it must not (extended regular expressions)
says() { grep -Eq -e "$1" out || fail "$command: does not say /$1/"; }
never_says() { if grep -Eq -e "$1" out; then fail "$command: says /$1/"; fi; }

# --- finding one's way
step 2 'stridor'
says 'stridor --help'
step 0 'stridor help'
says 'stridor init squeal -o squeal.toml'
step 0 'stridor help simulate'
says '--trace'
step 0 'stridor -v'
says '^stridor [0-9]'
step 2 'stridor simualte squeal.toml'
says '[Dd]id you mean .*simulate'
step 2 'stridor init sqeal'
says 'did you mean squeal'
step 2 'stridor library lst'
says '[Dd]id you mean .*list'
step 0 'COLUMNS=60 stridor simulate --help'
steps=$((steps + 1))
[ "$(grep -v '^ *stridor ' out | wc -L)" -le 60 ] || fail "help is wider than COLUMNS"

# --- a first case
step 0 'stridor init squeal -o squeal.toml'
step 0 'stridor init creak -o squeal.toml && stridor init squeal -o squeal.toml'
step 2 'sed "s/20 N/30 N/" squeal.toml > mine.toml; stridor init squeal -o mine.toml'
says 'force'
step 0 'stridor simulate squeal.toml'
says 'squeal'
says '1e-9 m/s|1 nm/s'
step 0 'stridor simulate squeal.toml --set mu_d=0.3 --set F=30'
step 2 'stridor simulate squeal.toml --set mu_dd=0.3'
says 'mu_d'
step 2 'stridor simulate squeal.toml --set contact.preload=0.5m'
says 'force'
step 0 'stridor check squeal.toml --set "preload=2 daN"'
says '20 N'
step 0 'stridor check squeal.toml --set "drive.frequency=300 rpm"'
says '5 Hz'
step 0 'stridor check squeal.toml --set "axial_damping=15 %"'
step 2 'stridor check squeal.toml --set "preload=8 n"'
never_says '[Dd]id you mean .?min'
step 5 'stridor simulate missing.toml'
says 'missing.toml'
step 5 'stridor simulate .'
step 2 'stridor simulate squeal.toml --trace t.txt'
says 'csv'

# --- errors come all at once, with their places
cat > wrong.toml <<'END'
[joint]
mass = "0.1 N"
axial_stifness = "1e7 N/m"
[contact]
preload = "-5 N"
impact = "elastic"
[drive]
kind = "constant"
velocity = "fast"
END
step 2 'stridor simulate wrong.toml'
for place in 2 3 5 6 9; do says "wrong.toml:$place:"; done
says 'axial_stiffness'

# --- changing the kind of drive by hand
sed -e 's/^kind = "sinusoidal"/kind = "constant"/' squeal.toml |
    awk '{ print } /^kind = "constant"/ { print "velocity = \"0.1 m/s\"" }' > constant.toml
step 0 'stridor simulate constant.toml'
says 'amplitude'
says 'warning'

# --- a part that stiffens in the cold
awk '/^axial_stiffness = /{ next } { print } END {
    print "[temperature]\nvalue = \"23 degC\"\nat = [\"-30 degC\", \"80 degC\"]"
    print "axial_stiffness = [\"2e7 N/m\", \"5e6 N/m\"]" }' \
    squeal.toml > cold.toml
step 0 'stridor simulate cold.toml --set temperature=-10'
step 2 'stridor simulate cold.toml --set temperature=100'
says '80'
step 0 'stridor chart cold.toml --x temperature=-30:80:6 --y preload=5:40:5 --out cold'

# --- tables
step 0 'stridor simulate squeal.toml --trace trace.csv'
step 0 'stridor classify trace.csv --channel velocity_x1'
says 'squeal'
step 2 'stridor classify trace.csv --channel nonsense'
says 'velocity_x1'
step 2 'stridor classify trace.csv --channel 99'
step 0 'stridor convert trace.csv'
never_says 'sampling rate'

# --- charts
step 0 'stridor chart squeal.toml --x preload=1:40:6 --y mu_d=0.2:0.8:5 --out pair'
[ -s pair/chart.svg ] || fail 'there is no pair/chart.svg'
step 0 'stridor chart squeal.toml --x preload=1:40:6 --y mu_d=0.2:0.8:5 --out pair'
says 'already|0 cells|nothing'
step 0 'stridor chart squeal.toml --x mu_d=0.2:0.8:9 --out line'
step 2 'stridor chart squeal.toml --out nothing'
says '--x'
step 2 'stridor stability squeal.toml --over mu_d=0.8:0'
step 0 'stridor stability squeal.toml --over mu_d=0:0.8'
says 'flutter'

# --- what to change, to hear and to hand over
step 0 'stridor advise constant.toml'
step 0 'stridor listen squeal.toml -o squeal.wav'
step 0 'stridor classify squeal.wav'
says 'squeal'
step 0 'stridor report squeal.toml -o report.html'
grep -q '<svg' report.html || fail 'the report has no drawing'

# --- the library
step 0 'stridor library starter'
step 0 'stridor library list'
says 'wiper'
mkdir sounds
cp squeal.wav sounds/one.wav
echo 'no sound at all' > sounds/broken.wav
step 2 'stridor library add sounds'
says 'added 1|1 added'
says 'broken.wav'
step 2 'stridor library add sounds'
says 'known'
step 0 'stridor init noise-chart -o pair.toml'
step 0 'stridor match squeal.wav --chart pair.toml --set chart.x.points=4 --set chart.y.points=4'
says 'squeal'

# --- the page
step 2 'stridor explore --port 80000'
says '65535'

echo "$steps steps, $failures failures"
[ "$failures" -eq 0 ]
