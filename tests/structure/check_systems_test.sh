#!/bin/sh
# Shows that check_systems.sh accepts a good tree and names what is wrong with each bad one.
set -eu

folder=$(dirname "$0")
. "$folder/bad_trees.sh"

check_tree() {
    sh "$folder/check_systems.sh" "$tree"
}

good_tree() {
    rm -rf "$tree/src" "$tree/apps" "$tree/python"
    mkdir -p "$tree/apps" "$tree/python"
    file src/stridor/parameters/system.cpp 'return !c.own_structure;'
    file src/stridor/io/case/writer.cpp 'if (c.own_structure) write();'
    file src/stridor/model/built/case_structure.cpp 'return c.own_structure ? own(c) : joints(c);'
    file src/stridor/report/page.cpp '#include "stridor/parameters/own_structure.hpp"' 'own_structure(c);'
}

good_tree
expect accepts "a case that is asked what it has" ''

file src/stridor/report/page.cpp 'if (c.own_structure) draw();'
expect rejects "a report that asks of which kind a case is" 'Ask parameters/system.hpp'

good_tree
file src/stridor/model/structure.cpp 'return at->own_structure;'
expect rejects "a model that asks it of a pointer" 'src/stridor/model/structure.cpp'

exit "$failures"
