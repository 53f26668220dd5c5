# What the tests of the checks of this folder share; each sources it and says what `check_tree` runs.

tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
root=$tree  # files stand below it
failures=0

# file PATH LINE...: a file of the tree
file() {
    mkdir -p "$root/$(dirname "$1")"
    path=$root/$1
    shift
    printf '%s\n' "$@" >"$path"
}

# expect VERDICT CLAIM PATTERN: the check accepts or rejects the tree, and says PATTERN
expect() {
    if output=$(check_tree 2>&1); then verdict=accepts; else verdict=rejects; fi
    if [ "$verdict" = "$1" ] && printf '%s\n' "$output" | grep -q -e "$3"; then
        echo "ok: $1 $2"
    else
        echo "FAILED: expected that it $1 $2 and says '$3'; it $verdict and says:"
        printf '%s\n' "$output"
        failures=$((failures + 1))
    fi
}
