#!/bin/sh
# Shows that check_docstrings.sh accepts a good tree and names what is wrong with each bad one.
set -eu

folder=$(dirname "$0")
. "$folder/bad_trees.sh"

check_tree() {
    sh "$folder/check_docstrings.sh" "$tree"
}

good_tree() {
    rm -rf "$tree/src" "$tree/apps"
    mkdir -p "$tree/apps"
    file src/a.hpp '/// A joint, and what it is for.' 'struct Joint {' '    /// The post must outlive it.' \
        '    explicit Joint(int post);' '    /// Reads it. The name counts.' '    void read();' '};' \
        '/// The most joints.' 'inline constexpr int most = max(1, 2);' \
        '/// Returns the name' '/// of a joint.' 'template <typename T>' 'T name_of(const Joint& joint);'
}

good_tree
expect accepts "verbs of functions, and nouns of the rest" ''

file src/b.hpp '/// The name of a joint.' 'int name_of(int joint);'
expect rejects "a noun" 'b.hpp:1: "The name of a joint."'

file src/b.hpp '' '/// Is it a joint?' 'template <typename T>' 'bool is_joint(const T& what) {'
expect rejects "a question" 'b.hpp:2: "Is it a joint?"'

file src/b.hpp '/// "1 joint", "2 joints".' '/// Returns the text.' 'int counted(int count);'
expect rejects "a quoted text" 'does not begin with a verb'

exit "$failures"
