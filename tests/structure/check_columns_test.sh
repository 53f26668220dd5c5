#!/bin/sh
# Shows that check_columns.sh finds a line that is too long wherever people write, and leaves alone what may be longer.
set -eu

folder=$(dirname "$0")
. "$folder/bad_trees.sh"
full=$(printf '%0120d' 0)
half=$(printf '%060d' 0)

check_tree() {
    sh "$folder/check_columns.sh" "$tree"
}

good_tree() {
    rm -rf "$tree"
    mkdir "$tree"
    file src/good.cpp "$full" ''
}

good_tree
expect accepts '120 columns' ''

good_tree
file src/signs.cpp "$(printf '%0119d' 0)ₙ"
expect accepts '120 columns of more bytes' ''

for name in src/bad.cpp src/bad.hpp src/bad.inl page/bad.ts page/build.mjs page/bad.css CMakeLists.txt bad.cmake \
    bad.sh bad.py; do
    good_tree
    file "$name" '' "$half $half"
    expect rejects "a long line in $name, with file and line" "121 columns.*\[$name:2\]"
done

good_tree
file dev '#!/bin/sh' "$half $half"
expect rejects 'a long line in a script without extension' '\[dev:2\]'

good_tree
file squeal.toml "$half $half"
file corpus/whole "$half $half"
file corpus/amr "#!AMR $half $half"
expect accepts 'data' ''

good_tree
file docs/page.md "- $half $half"
expect rejects 'a long line of prose' '123 columns.*\[docs/page.md:1\]'

good_tree
file docs/page.md "| $half | $half |" '```console' "$half $half" '```' "- [$full](page.md)"
expect accepts 'tables, fenced blocks and long links' ''

good_tree
file docs/page.md '```' "$half $half" '```' "$half $half"
expect rejects 'a long line below a fenced block' '\[docs/page.md:4\]'

good_tree
file build-debug/made.cpp "$full."
expect accepts 'what a build made' ''

good_tree
git -C "$tree" init -q
file src/new.cpp "$full."
git -C "$tree" add src/good.cpp
expect accepts 'what git does not track' ''
git -C "$tree" add src/new.cpp
expect rejects 'what git tracks' '\[src/new.cpp:1\]'

rm -rf "$tree"
mkdir "$tree"
expect rejects 'an empty tree' 'no files'

[ "$failures" -eq 0 ]
