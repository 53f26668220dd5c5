#!/bin/sh
# Holds the source tree against the order of the modules.
#
#     check_includes.sh SRC MODULE...      SRC holds stridor/<module>/; the modules in the order in which data flows
#
# Rules:
#   1. a file includes only headers of its own module or of modules earlier in the order;
#   2. files do not include each other in a circle;
#   3. a module up to and including `classification` knows no files, threads or terminals;
#   4. our headers are named from the include root ("stridor/<module>/..."), so that rules 1 and 2 see them;
#   5. a source includes the header of its own name first, which shows that the header compiles on its own.
#
# `io` reads and writes, and so stands late, at the edge, beside the things it stores: it may include `sweep`, but
# `sweep` may not include `io` (a chart does not need to know how it is written). Rule 1 says this already; the order
# alone keeps it true.
set -eu

circles=$(cat "$(dirname "$0")/circles.awk")
src=$1
shift
find "$src/stridor" -type f \( -name '*.hpp' -o -name '*.cpp' \) | LC_ALL=C sort |
    LC_ALL=C awk -v root="$src/" -v modules="$*" -v last_core=classification -v naming=include "$circles"'
function check_ours(place, file, module, header,    parts, count) {
    count = split(header, parts, "/")
    if (parts[1] != "stridor" || count < 3) {
        complain(place, "\"" header "\" is not named from the include root. Write \"stridor/<module>/...\"?")
        return
    }
    if (!(parts[2] in rank))
        complain(place, "\"" header "\" is in no known module. Is it missing in STRIDOR_MODULES?")
    else if (rank[parts[2]] > rank[module])
        complain(place, module " includes \"" header "\", but " parts[2] " comes after it (data flows one way).")
    edge[file, ++edges[file]] = header
}

function check_line(place, file, module, line,    header) {
    if (line !~ /^[ \t]*#[ \t]*include[ \t]*["<]/) return
    header = line
    includes[file]++
    sub(/^[^"<]*["<]/, "", header)
    sub(/[">].*$/, "", header)
    if (includes[file] == 1) first_include[file] = header
    if (line ~ /include[ \t]*"/)
        check_ours(place, file, module, header)
    else if (rank[module] <= rank[last_core] && (header in edge_of_the_world))
        complain(place, module " includes <" header ">, which belongs at the edges " \
            "(crew, sweep, io, report, explorer, apps).")
}

BEGIN {
    count = split(modules, order, " ")
    for (i = 1; i <= count; i++) rank[order[i]] = i
    if (!(last_core in rank)) complain("check_includes.sh", "The list of modules lacks " last_core ".")
    split("iostream fstream thread cstdio stdio.h filesystem", names, " ")
    for (i in names) edge_of_the_world[names[i]] = 1
}

{
    path = $0
    file = substr(path, length(root) + 1)
    files[++file_count] = file
    split(file, parts, "/")
    module = parts[2]
    if (!(module in rank)) {
        complain(file, "The file is in no known module. Is the module missing in STRIDOR_MODULES?")
        next
    }
    number = 0
    while ((getline line < path) > 0) check_line(file ":" ++number, file, module, line)
    close(path)
}

END {
    for (i = 1; i <= file_count; i++) known[files[i]] = 1
    for (i = 1; i <= file_count; i++) {
        own = files[i]
        if (sub(/\.cpp$/, ".hpp", own) && own in known && first_include[files[i]] != own)
            complain(files[i], "The source does not include \"" own "\" first.")
    }
    find_circles(files, file_count)
    if (file_count == 0) complain(root "stridor", "There are no source files to check.")
    if (problems) printf "%d problem(s) in %d files.\n", problems, file_count
    exit problems > 0
}'
