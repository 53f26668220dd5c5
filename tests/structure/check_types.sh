#!/bin/sh
# Holds the names of types against each other: one word means one thing.
#
#     check_types.sh ROOT [LIST]      ROOT holds src/ and apps/; LIST names those that may be shared, with the reason
#
# Rules:
#   1. no two headers define a type of one name;
#   2. no source defines a type by the name of a header's: its readers would take it for that one.
#
# A type is what begins a line as `struct`, `class`, `enum class` or `using NAME =`; namespaces are not indented, so
# these lines are the types of a namespace. What is declared only (`struct NAME;`) counts for nothing, nor do types
# within others, which are named with them. Lines of LIST: a name, then why it is shared; lines of # are comments.
set -eu

root=$1
list=${2:-$root/tests/structure/shared_types.txt}
find "$root/src" "$root/apps" -type f \( -name '*.hpp' -o -name '*.cpp' \) | LC_ALL=C sort |
    LC_ALL=C awk -v root="$root/" -v list="$list" '
function name_in(line,    words) {
    if (line ~ /^using [A-Za-z_0-9]+ =/ || line ~ /^(struct|class) [A-Za-z_0-9]+( final)?( :[^:].*)? \{/ ||
        line ~ /^enum class [A-Za-z_0-9]+/) {
        split(line, words, /[ :;]+/)
        return words[1] == "enum" ? words[3] : words[2]
    }
    return ""
}

function add(files_of, name, file) {
    if (name in files_of) files_of[name] = files_of[name] ", " file
    else files_of[name] = file
}

BEGIN {
    while ((getline line < list) > 0)
        if (line !~ /^#/ && split(line, words, " ") > 1) allowed[words[1]] = 1
        else if (line !~ /^#/ && line != "") {
            printf "\"%s\" in the list of shared names has no reason. [%s]\n", line, list
            problems++
        }
    close(list)
}

{
    path = $0
    file = substr(path, length(root) + 1)
    files++
    while ((getline line < path) > 0) {
        name = name_in(line)
        if (name == "") continue
        types++
        if (file ~ /\.hpp$/) add(headers, name, file)
        else add(sources, name, file)
    }
    close(path)
}

END {
    for (name in headers) {
        used = (name in sources) || headers[name] ~ /,/
        if (used && !(name in allowed)) {
            printf "%s is more than one type. Give one of them a name of its own? [%s%s]\n", name, headers[name],
                (name in sources ? ", " sources[name] : "") | "LC_ALL=C sort"
            problems++
        }
        if (used) shared[name] = 1
    }
    for (name in allowed)
        if (!(name in shared)) {
            printf "%s is on the list of shared names and is shared no more. [%s]\n", name, list | "LC_ALL=C sort"
            problems++
        }
    close("LC_ALL=C sort")
    if (types == 0) {
        print "There are no types to check."
        problems++
    }
    if (problems) printf "%d problem(s) among %d types in %d files.\n", problems, types, files
    exit problems > 0
}'
