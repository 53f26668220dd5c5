#!/bin/sh
# Does docs_examples_test.sh find a page that says something else than the program? docs_examples_harness_test.sh FOLDER
set -u
harness=$1/docs_examples_test.sh
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
mkdir "$work/source"
program=$work/program
cat >"$program" <<'END'
#!/bin/sh
case $1 in
    silent) ;;
    warn) echo careful >&2 ;;
    lines) printf 'one\ntwo\nthree\nfour  \n\n' ;;
    fail) echo no; exit 2 ;;
esac
END
chmod +x "$program"

failures=0
tests=0

# the block $2, its lines parted by "|", as a page: is it called right ($1 = agrees) or wrong ($1 = differs)?
expect() {
    tests=$((tests + 1))
    printf '```console|%s|```\n' "$2" | tr '|' '\n' >"$work/page.md"
    sh "$harness" "$program" "$work/source" "$work/page.md" >"$work/log" 2>&1
    code=$?
    wanted=0
    [ "$1" = agrees ] || wanted=1
    [ "$code" -eq "$wanted" ] && return
    failures=$((failures + 1))
    echo "expected that it $1, exit code is $code:"
    cat "$work/page.md" "$work/log"
}

expect agrees '$ stridor silent|$ stridor lines|one|two|three|four|$ stridor fail # exit 2|no'
expect differs '$ stridor fail # exit 3|no'
# a command without output must be silent, also in the midst of others and before a blank line
expect differs '$ stridor lines'
expect differs '$ stridor warn||$ stridor silent'
expect differs '$ stridor silent|something'
# "..." stands for one or more lines
for lines in '...' 'one|...' '...|four' '...|three|...' 'one|...|four' 'one|two|...|four' 'one|...|three|four'; do
    expect agrees "$ stridor lines|$lines"
done
for lines in 'two|...' '...|three' 'one|two|three|four|...' '...|one|...' 'one|...|two|three|four' 'one|...|five|...' \
    '...|three|two|...' 'one|two|...|three|four'; do
    expect differs "$ stridor lines|$lines"
done
expect differs '$ stridor silent|...'

# --update writes what is printed, and leaves what agrees
printf '```console\n$ stridor lines\n$ stridor lines\none\n...\n$ stridor silent\ngone\n\n$ stridor \\\n  warn\n```\n' \
    >"$work/page.md"
{
    printf '```console\n$ stridor lines\none\ntwo\nthree\nfour\n$ stridor lines\none\n...\n'
    printf '$ stridor silent\n$ stridor \\\n  warn\ncareful\n```\n'
} >"$work/wanted.md"
sh "$harness" --update "$program" "$work/source" "$work/page.md" >"$work/log" 2>&1 || failures=$((failures + 1))
tests=$((tests + 1))
diff "$work/wanted.md" "$work/page.md" || failures=$((failures + 1))

echo "$tests tests, $failures failed"
[ "$failures" -eq 0 ]
