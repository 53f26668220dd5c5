#!/bin/sh
# Data that nobody gets is never called done: stdout that is closed, full or that nobody reads any more.
# usage: streams_test.sh PROGRAM
set -u
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

# expect STATUS DESCRIPTION: the status of the last command
expect() {
    status=$?
    [ "$status" -eq "$1" ] && return
    echo "$2: exit status $status instead of $1"
    cat err
    failures=$((failures + 1))
}

"$program" init squeal -o squeal.toml 2> err
expect 0 "init -o"

# every way to print: a document, a table, help and version, completions
for words in "simulate squeal.toml --set run.window=0.3 --set run.duration=0.3 --json" \
    "simulate squeal.toml --set run.window=0.3 --set run.duration=0.3" "init squeal" "check squeal.toml" "--help" \
    "--version" "chart --help" "completion bash" "library fields" "stability squeal.toml --json"; do
    # shellcheck disable=SC2086
    "$program" $words > /dev/full 2> err
    expect 5 "$words > /dev/full"
    grep -q "standard output" err || { echo "$words > /dev/full does not say why"; failures=$((failures + 1)); }
    # shellcheck disable=SC2086
    "$program" $words >&- 2> err
    expect 5 "$words >&-"
    # nobody reads any more: it ends as other programs do, by SIGPIPE (128 + 13), without a word
    mkfifo pipe
    : < pipe &
    reader=$!
    exec 3> pipe
    wait "$reader"
    # shellcheck disable=SC2086
    "$program" $words >&3 2> err
    expect 141 "$words into a pipe that nobody reads"
    exec 3>&-
    rm pipe
done
[ "$failures" -eq 0 ]
