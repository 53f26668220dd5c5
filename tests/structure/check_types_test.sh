#!/bin/sh
# Shows that check_types.sh accepts a good tree and names what is wrong with each bad one.
set -eu

folder=$(dirname "$0")
. "$folder/bad_trees.sh"

check_tree() {
    sh "$folder/check_types.sh" "$tree" "$tree/list.txt"
}

good_tree() {
    rm -rf "$tree/src" "$tree/apps"
    mkdir -p "$tree/apps"
    : >"$tree/list.txt"
    file src/a/range.hpp 'struct Range {' '    struct Part {' 'struct Later;' 'enum class Colour : int {'
    file src/b/other.hpp 'class Other final : public Range {' '    struct Part {' 'struct Range;'
    file src/b/other.cpp 'struct Local {'
    file src/c/third.cpp 'struct Local {'
}

good_tree
expect accepts "types of one name each" ''

file src/c/again.hpp 'struct Range {'
expect rejects "two headers with one type" 'Range is more than one type'

echo 'Range both are what a reader expects' >"$tree/list.txt"
expect accepts "a type that is on the list" ''

echo 'Range' >"$tree/list.txt"
expect rejects "a list without a reason" 'has no reason'

good_tree
echo 'Range once there were two' >"$tree/list.txt"
expect rejects "a list that is out of date" 'is shared no more'

good_tree
file src/c/third.cpp 'using Colour = int;'
expect rejects "a source that takes the name of a header's type" 'Colour is more than one type'

rm -rf "$tree/src"
mkdir "$tree/src"
expect rejects "an empty tree" 'no types to check'

exit "$failures"
