#!/bin/sh
# Shows that check_libm.sh finds calls of the C library where a sound is judged, and leaves alone what is none.
set -eu

folder=$(dirname "$0")
. "$folder/bad_trees.sh"

check_tree() {
    sh "$folder/check_libm.sh" "$tree"
}

good_tree() {
    rm -rf "$tree"
    mkdir "$tree"
    for module in signal sound classification hearing; do
        file "stridor/$module/good.cpp" 'double f(double x) {' '    return std::sqrt(x);' '}'
    done
}

good_tree
expect accepts 'a square root' ''

good_tree
file stridor/sound/good.cpp 'base::logarithm_2(x) + base::exponential(x) + catalogue(x) + a.log(x);  // not std::log(x)'
expect accepts 'functions of our own, and words in a comment' ''

good_tree
file stridor/model/good.cpp 'std::exp(x);'
expect accepts 'other modules' ''

for call in std::log10 std::pow std::sin std::expm1 std::hypot std::atan2 logf exp2; do
    good_tree
    file stridor/signal/bad.hpp '' "    return 2.0 * $call(x);"
    expect rejects "$call, with file and line" 'signal/bad.hpp:2 calls the C library'
done

good_tree
rm -r "$tree/stridor/sound"
expect rejects 'a tree that lacks a module' 'sound'

[ "$failures" -eq 0 ]
