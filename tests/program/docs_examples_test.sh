#!/bin/sh
# Runs every example of the documentation and holds what the program prints against what the page says.
#
#     docs_examples_test.sh [--update] PROGRAM SOURCE_FOLDER [PAGE.md ...]
#
# An example is a line "$ command" in a block fenced by ```console. Lines below it are its expected output, standard
# output and standard error together; without such lines it must print nothing. A line "..." stands for one or more
# lines that the page leaves out. A command may end with a comment "# exit 2" that names the exit code it must have. A
# line that ends with a backslash goes on in the next line. The examples of one page run one after the other in one
# empty folder, with PROGRAM on the PATH as `stridor` and SOURCE_FOLDER as STRIDOR_SOURCE.
#
# --update writes the real output into the pages where it is another; read the difference before you commit it.
set -u

update=no
if [ "${1:-}" = --update ]; then
    update=yes
    shift
fi
if [ $# -lt 2 ]; then
    echo "usage: $0 [--update] PROGRAM SOURCE_FOLDER [PAGE.md ...]" >&2
    exit 2
fi
program=$1
source=$(cd "$2" && pwd) || exit 2
shift 2
if [ ! -x "$program" ]; then
    echo "$program is not a program" >&2
    exit 2
fi

work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
mkdir "$work/bin"
ln -s "$(cd "$(dirname "$program")" && pwd)/$(basename "$program")" "$work/bin/stridor"
PATH=$work/bin:$PATH
STRIDOR_SOURCE=$source
export PATH STRIDOR_SOURCE NO_COLOR=1 LC_ALL=C

if [ $# -eq 0 ]; then
    set -- "$source/README.md"
    for page in $(find "$source/docs" -name '*.md' | LC_ALL=C sort); do
        set -- "$@" "$page"
    done
fi

# the examples of a page: N.command, N.expected (if it has any), N.place
take_apart() {
    awk -v folder="$2" -v page="$1" '
        function file(kind) { return folder "/" number "." kind }
        function finish() { if (number > 0) { close(file("command")); close(file("expected")); close(file("place")) } }
        /^```console[ \t]*$/ { is_inside = 1; has_command = 0; next }
        /^```/ && is_inside { is_inside = 0; finish(); next }
        !is_inside { next }
        continues { print > file("command"); continues = /\\$/; next }
        /^\$ / {
            finish(); number++; has_command = 1
            print substr($0, 3) > file("command")
            print page ":" FNR > file("place")
            continues = /\\$/
            next
        }
        has_command { print > file("expected") }
        END { print number + 0 }' "$1"
}

# a page with the real output in place of the expected one, but for examples with N.keep
put_together() {
    awk -v folder="$2" '
        function file(kind) { return folder "/" number "." kind }
        function keeps(   line, found) {
            found = (getline line < file("keep")) >= 0
            close(file("keep"))
            return found
        }
        function real(   line) {
            while ((getline line < file("actual")) > 0) print line
            close(file("actual"))
        }
        function end_of_command() {
            continues = /\\$/
            if (continues || keeps()) return
            real()
            is_skipping = 1
        }
        /^```console[ \t]*$/ { is_inside = 1; is_skipping = 0; print; next }
        /^```/ && is_inside { is_inside = 0; print; next }
        !is_inside { print; next }
        continues { print; end_of_command(); next }
        /^\$ / { print; number++; is_skipping = 0; end_of_command(); next }
        !is_skipping { print }' "$1"
}

# without blanks at line ends and blank lines at the end
tidy() {
    awk '
        { sub(/[ \t]+$/, ""); line[NR] = $0 }
        END { while (NR > 0 && line[NR] == "") NR--; for (k = 1; k <= NR; k++) print line[k] }'
}

# Do the lines of the file $2 agree with those of $1, where "..." stands for one or more lines? What lies between two
# such marks is looked for from above; the last lines must end the output.
agree() {
    awk -v expected="$1" '
        function matches(first, size, at,   k) {
            for (k = 0; k < size; k++) if (at + k > lines || wanted[first + k] != line[at + k]) return 0
            return 1
        }
        { line[++lines] = $0 }
        END {
            while ((getline text < expected) > 0) wanted[++count] = text
            at = 1
            for (first = 1; ; first = next_one + 1) {
                for (next_one = first; next_one <= count && wanted[next_one] != "..."; next_one++) {}
                size = next_one - first
                is_last = next_one > count
                if (first == 1 && is_last) exit !(size == lines && matches(1, size, 1))
                if (first == 1) {
                    if (!matches(1, size, 1)) exit 1
                    at = size + 1
                    continue
                }
                at++ # the line that the mark stands for at least
                if (is_last) exit !(lines - size + 1 >= at && matches(first, size, lines - size + 1))
                while (at <= lines && !matches(first, size, at)) at++
                at += size
            }
        }' "$2"
}

examples=0
failures=0
pages=0
for page in "$@"; do
    pages=$((pages + 1))
    parts=$work/parts$pages
    folder=$work/folder$pages
    mkdir "$parts" "$folder"
    count=$(take_apart "$page" "$parts")
    number=0
    while [ "$number" -lt "$count" ]; do
        number=$((number + 1))
        examples=$((examples + 1))
        wanted=$(sed -n 's/.*# exit \([0-9][0-9]*\)[ \t]*$/\1/p' "$parts/$number.command" | tail -n 1)
        (cd "$folder" && sh "$parts/$number.command" </dev/null) >"$parts/$number.raw" 2>&1
        code=$?
        tidy <"$parts/$number.raw" >"$parts/$number.actual"
        if [ "$code" -ne "${wanted:-0}" ]; then
            failures=$((failures + 1))
            echo "$(cat "$parts/$number.place"): exit code $code, expected ${wanted:-0}:"
            sed 's/^/    $ /' "$parts/$number.command"
            sed 's/^/    /' "$parts/$number.actual" | head -n 40
            continue
        fi
        touch "$parts/$number.expected"
        tidy <"$parts/$number.expected" >"$parts/$number.tidy"
        if agree "$parts/$number.tidy" "$parts/$number.actual"; then
            touch "$parts/$number.keep"
        elif [ "$update" = no ]; then
            failures=$((failures + 1))
            echo "$(cat "$parts/$number.place"): the page (<) says something else than the program (>):"
            sed 's/^/    $ /' "$parts/$number.command"
            diff "$parts/$number.tidy" "$parts/$number.actual" | sed 's/^/    /' | head -n 40
        fi
    done
    if [ "$update" = yes ]; then
        put_together "$page" "$parts" >"$work/page" && { cmp -s "$work/page" "$page" || cat "$work/page" >"$page"; }
    fi
    rm -rf "$folder"
done

echo "$examples examples on $pages pages, $failures failed"
if [ "$examples" -eq 0 ]; then
    echo "no examples found: is this the right folder?" >&2
    exit 2
fi
[ "$failures" -eq 0 ] && exit 0
[ "$update" = yes ] || echo "If the program is right: $0 --update PROGRAM SOURCE_FOLDER"
exit 1
