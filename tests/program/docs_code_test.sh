#!/bin/sh
# Compiles the C++ of the documentation: each block fenced by ```cpp whose first line begins with #include.
#
#     docs_code_test.sh SOURCE_FOLDER PAGE.md ... -- COMPILER [OPTION ...]
set -u

source=$(cd "$1" && pwd) || exit 2
shift
pages=
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    pages="$pages $1"
    shift
done
[ $# -gt 1 ] || { echo "usage: $0 SOURCE_FOLDER PAGE.md ... -- COMPILER [OPTION ...]" >&2; exit 2; }
shift

work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
blocks=0
failures=0
for page in $pages; do
    # a file per block, named by the line it begins in
    awk -v folder="$work" '
        /^[ ]*```cpp[ \t]*$/ { is_first = 1; next }
        /^[ ]*```/ { if (file) close(file); file = ""; is_first = 0; next }
        is_first { is_first = 0; if ($0 ~ /^[ ]*#include/) file = folder "/" FNR ".cpp" }
        file { print > file }' "$source/$page"
    for block in "$work"/*.cpp; do
        [ -e "$block" ] || continue
        blocks=$((blocks + 1))
        "$@" -I "$source/src" -I "$source/apps/stridor" -fsyntax-only "$block" >"$work/said" 2>&1 || {
            failures=$((failures + 1))
            echo "$page:$(basename "$block" .cpp): does not compile"
            sed 's/^/    /' "$work/said" | head -n 20
        }
        rm "$block"
    done
done
echo "$blocks blocks of C++, $failures failed"
[ "$blocks" -gt 0 ] && [ "$failures" -eq 0 ]
