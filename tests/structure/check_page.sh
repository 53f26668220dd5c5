#!/bin/sh
# Holds the page's source tree against the order of its folders.
#
#     check_page.sh SRC FOLDER...      SRC holds <folder>/ and, beside them, what puts the page together; the folders in
#                                      the order in which data flows
#
# Rules:
#   1. a file imports only from its own folder or from folders earlier in the order;
#   2. files do not import each other in a circle;
#   3. what lies beside the folders (main.ts) may import from all of them, and none of them from it;
#   4. our files are named with their path and extension ("../data/api.ts"), so that rules 1 to 3 see them.
#
# An import of types alone counts as any other: who knows a type knows its folder.
set -eu

circles=$(cat "$(dirname "$0")/circles.awk")
src=$1
shift
find "$src" -type f -name '*.ts' | LC_ALL=C sort |
    LC_ALL=C awk -v root="$src/" -v folders="$*" -v naming=import "$circles"'
# the first part of a path; empty for a file beside the folders
function folder_of(file) {
    return file ~ /\// ? substr(file, 1, index(file, "/") - 1) : ""
}

# "views/chart.ts" and "../data/api.ts": data/api.ts
function resolved(file, import_path,    place) {
    place = file
    sub(/[^\/]*$/, "", place)
    sub(/^\.\//, "", import_path)
    while (import_path ~ /^\.\.\//) {
        sub(/^\.\.\//, "", import_path)
        if (place == "") return "../" import_path
        sub(/[^\/]*\/$/, "", place)
    }
    return place import_path
}

function check_import(place, file, import_path,    target, from, to) {
    target = resolved(file, import_path)
    if (target ~ /\.css$/) return
    if (!(target in known)) {
        complain(place, "\"" import_path "\" is no file of the page. Write its path with its extension?")
        return
    }
    from = folder_of(file)
    to = folder_of(target)
    if (from != "" && to == "")
        complain(place, from " imports \"" target "\", which puts the page together and comes after all folders.")
    else if (from != "" && rank[to] > rank[from])
        complain(place, from " imports \"" target "\", but " to " comes after it (data flows one way).")
    edge[file, ++edges[file]] = target
}

# the last line of an import or a re-export, or an import on demand
function check_line(place, file, line,    import_path) {
    if (line ~ /^[ \t]*[\/*]/) return  # a comment
    while (match(line, /(from|import)[ \t(]*["\047`]\.[^"\047`]*/)) {
        import_path = substr(line, RSTART, RLENGTH)
        line = substr(line, RSTART + RLENGTH)
        sub(/^[^"\047`]*["\047`]/, "", import_path)
        check_import(place, file, import_path)
    }
}

BEGIN {
    count = split(folders, order, " ")
    for (i = 1; i <= count; i++) rank[order[i]] = i
}

{
    files[++file_count] = substr($0, length(root) + 1)
    known[files[file_count]] = 1
}

END {
    for (i = 1; i <= file_count; i++) {
        file = files[i]
        if (folder_of(file) != "" && !(folder_of(file) in rank)) {
            complain(file, "The file is in no known folder. Is the folder missing in the list of tests/structure?")
            continue
        }
        number = 0
        while ((getline line < (root file)) > 0) check_line(file ":" ++number, file, line)
        close(root file)
    }
    find_circles(files, file_count)
    if (!file_count) complain(root, "There are no source files to check.")
    if (problems) printf "%d problem(s) in %d files.\n", problems, file_count
    exit problems > 0
}'
