#!/bin/sh
# Shows that check_includes.sh accepts a good tree and names what is wrong with each bad one.
set -eu

folder=$(dirname "$0")
. "$folder/bad_trees.sh"
root=$tree/stridor

check_tree() {
    sh "$folder/check_includes.sh" "$tree" base model classification chart io
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
