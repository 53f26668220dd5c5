#!/bin/sh
# Holds the first words of docstrings: what a function does is a verb, "Returns the name of a joint."
#
#     check_docstrings.sh ROOT      ROOT holds src/ and apps/
#
# Rule: the docstring (`///`) of a function begins with a verb in the third person, which ends in -s ("Returns", "Says
# whether"); not with a noun, a question or a quoted text. Constructors, types and values are free.
set -eu

root=$1
find "$root/src" "$root/apps" -type f \( -name '*.hpp' -o -name '*.inl' \) | LC_ALL=C sort |
    LC_ALL=C xargs awk '
function is_function(line) {
    sub(/^ +/, "", line)
    if (line !~ /\(/ || line ~ /^(#|struct|class|enum|namespace|using|union|concept|explicit|~)/) return 0
    if (line ~ /^[A-Z][A-Za-z0-9]*\(/) return 0                       # a constructor
    line = substr(line, 1, index(line, "(") - 1)
    return line !~ /[={]/
}

function judge(declaration) {
    if (text != "" && is_function(declaration) && text !~ /^[A-Z][a-z]+s[ ,:]/) {
        printf "%s:%d: \"%s\" does not begin with a verb, such as \"Returns\" or \"Says whether\".\n", file, at, text
        problems++
    }
    text = ""
}

FNR == 1 { text = "" }
/^ *\/\/\// {
    if (text == "") {
        text = $0
        sub(/^ *\/\/\/ */, "", text)
        file = FILENAME
        at = FNR
    }
    next
}
/^ *(template|requires)/ && !/\(/ { next }
{ if (text != "") judge($0) }
END { exit problems > 0 }'
