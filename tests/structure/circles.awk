# Finds circles among files. Prefixed to the program of check_includes.sh and check_page.sh, which fill
# edge[file, 1..edges[file]] with the files that a file names, and say by `naming` what that is called.

function complain(place, text) {
    printf "%s [%s]\n", text, place
    problems++
}

# Depth first: a file met again while it is still open closes a circle. chain is the way from the start to here.
function visit(file, chain,    i, next_file) {
    mark[file] = "open"
    for (i = 1; i <= edges[file]; i++) {
        next_file = edge[file, i]
        if (!(next_file in mark))
            visit(next_file, chain " -> " next_file)
        else if (mark[next_file] == "open")
            complain(file, "Files " naming " each other in a circle: " chain " -> " next_file)
    }
    mark[file] = "done"
}

function find_circles(files, count,    i) {
    for (i = 1; i <= count; i++)
        if (!(files[i] in mark)) visit(files[i], files[i])
}

