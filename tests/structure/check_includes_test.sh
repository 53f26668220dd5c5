#!/bin/sh
# Shows that check_includes.sh accepts a good tree and names what is wrong with each bad one.
set -eu

check=$(dirname "$0")/check_includes.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

# file PATH LINE...: a source file under the tree
file() {
    mkdir -p "$tree/stridor/$(dirname "$1")"
    path=$tree/stridor/$1
    shift
    printf '%s\n' "$@" >"$path"
}

good_tree() {
    rm -rf "$tree/stridor"
    file base/error.hpp '#pragma once' '#include <string>'
    file base/error.cpp '#include "stridor/base/error.hpp"'
    file model/friction/law.hpp '#include "stridor/base/error.hpp"' '#include <cmath>'
    file classification/verdict.cpp '#include "stridor/model/friction/law.hpp"' '// #include <iostream>'
    file chart/scene.hpp '#include "stridor/model/friction/law.hpp"' '#include <fstream>'
    file io/svg.cpp '#  include "stridor/chart/scene.hpp"  // drawn here'
}

# expect VERDICT CLAIM PATTERN: the check accepts or rejects the tree, and says PATTERN
expect() {
    if output=$(sh "$check" "$tree" base model classification chart io 2>&1); then
        verdict=accepts
    else
        verdict=rejects
    fi
    if [ "$verdict" = "$1" ] && printf '%s\n' "$output" | grep -q -e "$3"; then
        echo "ok: $1 $2"
    else
        echo "FAILED: expected that it $1 $2 and says '$3'; it $verdict and says:"
        printf '%s\n' "$output"
        failures=$((failures + 1))
    fi
}

good_tree
expect accepts 'a tree whose includes flow one way' ''

good_tree
file base/back.cpp '' '#include "stridor/model/friction/law.hpp"'
expect rejects 'an include of a later module, with file and line' 'comes after it.*\[stridor/base/back.cpp:2\]'

good_tree
file chart/draw.cpp '#include "stridor/io/svg.hpp"'
expect rejects 'a chart that includes io' 'io comes after it'

good_tree
file model/a.hpp '#include "stridor/model/b.hpp"'
file model/b.hpp '#include "stridor/model/c.hpp"'
file model/c.hpp '#include "stridor/model/a.hpp"'
expect rejects 'files that include each other' \
    'model/a.hpp -> stridor/model/b.hpp -> stridor/model/c.hpp -> stridor/model/a.hpp'

good_tree
file base/error.cpp '#include <string>' '#include "stridor/base/error.hpp"'
expect rejects 'a source that does not begin with its header' 'does not include "stridor/base/error.hpp" first'

for header in iostream fstream thread cstdio stdio.h filesystem; do
    good_tree
    file classification/prints.cpp "#include <$header>"
    expect rejects "<$header> in the core" "<$header>, which belongs at the edges"
done

good_tree
file base/near.cpp '#include "error.hpp"'
expect rejects 'a header not named from the include root' 'not named from the include root'

good_tree
file extras/new.cpp ''
expect rejects 'a folder that is no module' 'in no known module'

good_tree
file io/uses_extras.cpp '#include "stridor/extras/new.hpp"'
expect rejects 'an include from a folder that is no module' 'in no known module'

rm -rf "$tree/stridor"
mkdir "$tree/stridor"
expect rejects 'an empty tree' 'no source files'

[ "$failures" -eq 0 ]
