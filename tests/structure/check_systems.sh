#!/bin/sh
# A system is one thing: what a case has is asked of parameters/system.hpp, and of which kind it is nobody asks.
#
#     check_systems.sh ROOT      ROOT holds src/, apps/ and python/
#
# Rule: the structure of the user's own (`own_structure`) is looked at only by what resolves a case
# (src/stridor/parameters), by what reads and writes it (src/stridor/io) and by the builders of its matrices
# (src/stridor/model/built).
set -eu

root=$1
cd "$root"
if grep -rnE --include='*.hpp' --include='*.cpp' --include='*.inl' '(\.|->)own_structure([^_a-z.]|$)' src apps python |
    grep -vE '^src/stridor/(parameters|io|model/built)/' >&2; then
    echo "The lines above ask of which kind a case is. Ask parameters/system.hpp what it has." >&2
    exit 1
fi
