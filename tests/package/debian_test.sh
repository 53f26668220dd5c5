#!/bin/sh
# The packages for Debian as root installs, uses and removes them on this machine: debian_test.sh FOLDER CONSUMER
#
# FOLDER has stridor_*.deb and may have stridor-mpi_*.deb; CONSUMER is a project that finds the library by CMake.
set -eu
packages=$(cd "$1" && pwd)
consumer=$(cd "$2" && pwd)

fail() {
    echo "FAILED: $*" >&2
    exit 1
}

[ "$(id -u)" -eq 0 ] || fail "only root can install packages"
for package in stridor stridor-mpi; do
    if dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -q '^installed$'; then
        fail "$package is installed on this machine; the test would remove it"
    fi
done
folder=$(mktemp -d)
installed=""
finish() {
    [ -z "$installed" ] || dpkg --purge $installed >/dev/null 2>&1 || true
    rm -rf "$folder"
}
trap finish EXIT
cd "$folder"
export DEBIAN_FRONTEND=noninteractive
# nothing of a checkout may be used in place of what is installed
unset PYTHONPATH
PATH=/usr/sbin:/usr/bin:/sbin:/bin

# what there is of Stridor below /usr
ours() {
    find /usr -xdev -path /usr/src -prune -o -name '*stridor*' -print | sort
}

# install NAME: what it depends on comes from Debian
install_package() {
    installed="$1 $installed"
    apt-get install -q -y --no-install-recommends -o DPkg::Lock::Timeout=600 "$packages/$1"_*.deb >apt.txt 2>&1 ||
        { cat apt.txt; fail "$1 cannot be installed"; }
}

ours >before.txt
install_package stridor

echo "the program"
stridor --version
stridor init squeal | stridor simulate - | grep -q '^going   squeal .* 428.5 Hz' || fail "another squeal"
stridor init noise-chart |
    stridor chart - --set chart.x.points=8 --set chart.y.points=8 --set run.duration=0.3 --set run.window=0.1 \
        --out chart >/dev/null
find chart -name '*.nc' | grep -q . || fail "no netCDF"
find chart -name '*.png' | grep -q . || fail "no picture"

echo "the Python module"
python3 -c '
import stridor
motion = stridor.simulate(stridor.case("squeal"))
assert motion.going.category == "squeal", motion
assert stridor.__file__.startswith("/usr/lib/python3/dist-packages/"), stridor.__file__
'
[ -f /usr/lib/python3/dist-packages/stridor/py.typed ] || fail "no py.typed"

echo "the library"
cmake -S "$consumer" -B consumer -DCMAKE_BUILD_TYPE=Release >cmake.txt 2>&1 || { cat cmake.txt; fail "not found"; }
cmake --build consumer >cmake.txt 2>&1 || { cat cmake.txt; fail "cannot be linked"; }
./consumer/consumer >/dev/null

echo "the manual page, the completions, the documents"
# small machines are set up to leave documents away
dpkg-deb -x "$packages"/stridor_*.deb content
zcat content/usr/share/man/man1/stridor.1.gz | grep -q '^\.TH' || fail "no manual page"
for file in bash-completion/completions/stridor zsh/vendor-completions/_stridor fish/vendor_completions.d/stridor.fish \
    doc/stridor/copyright doc/stridor/docs/guide/getting-started.md stridor/cases/squeal.toml; do
    [ -s "content/usr/share/$file" ] || fail "no $file"
done
dpkg --verify stridor >verify.txt
if grep -v '^missing */usr/share/\(doc\|man\)' verify.txt; then fail "files differ from the package's"; fi

if [ -n "$(find "$packages" -name 'stridor-mpi_*.deb')" ]; then
    echo "the program for clusters"
    ldd /usr/bin/stridor | grep -q libmpi && fail "stridor links MPI"
    install_package stridor-mpi
    stridor-mpi --version
fi

echo "removed"
dpkg --purge $installed >/dev/null
installed=""
ours >after.txt
diff before.txt after.txt || fail "something is left"
