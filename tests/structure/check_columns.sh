#!/bin/sh
# Finds lines beyond 120 columns in what people write.
#
#     check_columns.sh ROOT
#
# It looks at the files that git tracks; without git, in an unpacked archive, at all outside of build folders. Of these,
# at C++, TypeScript, JavaScript, CSS, HTML, CMake, shell, Python and Markdown, told by the extension, and at scripts
# without one, told by #!/. A column is a character, not a byte. In Markdown these may be longer: rows of tables, fenced
# blocks (the output of a program is what it is), and lines without a blank to break them at, such as a long link.
set -eu

root=$1
list() {
    git -C "$root" -c core.quotePath=false ls-files 2>/dev/null | grep . ||
        (cd "$root" && find . -type d \( -name .git -o -name node_modules -o -name 'build*' \) -prune -o \
            -type f -print | sed 's,^\./,,')
}

list | LC_ALL=C sort | LC_ALL=C awk -v root="$root/" -v most=120 '
function is_written(path,    name) {
    name = path
    sub(/.*\//, "", name)
    if (name ~ /\.(cpp|hpp|inl|ts|js|mjs|css|html|cmake|sh|py|md)$/ || name == "CMakeLists.txt") return 1
    return name !~ /\./ && (getline line < (root path)) > 0 && line ~ /^#!\//
}

# UTF-8: the first byte of a character counts, the others do not
function columns(text) {
    gsub(/[\200-\277]/, "", text)
    return length(text)
}

function may_be_longer(text) {
    sub(/^ *([-*+] |[0-9]+[.] )? */, "", text)
    return is_fenced || text ~ /^\|/ || text !~ / /
}

is_written($0) {
    files++
    path = root $0
    close(path)
    is_markdown = $0 ~ /\.md$/
    is_fenced = number = 0
    while ((getline line < path) > 0) {
        number++
        if (is_markdown && line ~ /^ *(```|~~~)/) is_fenced = !is_fenced
        if (length(line) <= most || columns(line) <= most || (is_markdown && may_be_longer(line))) continue
        printf "A line of %d columns; at most %d are read with ease. Break it? [%s:%d]\n", columns(line), most, $0,
            number
        problems++
    }
    close(path)
}

END {
    if (!files) print "There are no files to check [" root "]."
    if (problems) printf "%d line(s) are too long, in %d files.\n", problems, files
    exit !files || problems > 0
}'
