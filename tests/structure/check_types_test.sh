#!/bin/sh
# Shows that check_types.sh accepts a good tree and names what is wrong with each bad one.
set -eu

check=$(dirname "$0")/check_types.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

# file PATH LINE...: a source file under the tree
file() {
    mkdir -p "$tree/$(dirname "$1")"
    path=$tree/$1
    shift
    printf '%s\n' "$@" >"$path"
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

# expect VERDICT CLAIM PATTERN: the check accepts or rejects the tree, and says PATTERN
expect() {
    if output=$(sh "$check" "$tree" "$tree/list.txt" 2>&1); then
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
