#!/bin/sh
# The Python package from the sources alone, with the program that it starts: pip_test.sh CHECKOUT
set -eu
checkout=$(cd "$1" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
unset PYTHONPATH

/usr/bin/python3 -m venv --system-site-packages venv
venv/bin/pip install --no-index "$checkout"
venv/bin/python -c '
import stridor
assert stridor.simulate(stridor.case("squeal")).going.category == "squeal"
print(stridor.__file__)
' | grep "^$folder/venv/"
PATH=/usr/bin:/bin venv/bin/python -c '
import stridor
with stridor.explore("squeal", browser="none") as explorer:
    print(explorer._process.args[0])
' | grep "^$folder/venv/bin/stridor$"
venv/bin/pip uninstall --yes stridor
if find venv -name '*stridor*' | grep .; then
    echo "FAILED: something is left" >&2
    exit 1
fi
