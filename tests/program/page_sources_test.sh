#!/bin/sh
# Compares what the program writes for the page with the page's copies in explorer/src/program.
#
#     page_sources_test.sh PROGRAM ROOT [--update]      --update writes them anew
set -eu

program=$1
folder=$2/explorer/src/program
update=${3-}
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT

for name in palette words; do
    "$program" explore --typescript "$name" >"$made/$name.ts"
    if [ "$update" = --update ]; then cp "$made/$name.ts" "$folder/$name.ts"; fi
done
if ! diff -ru "$folder" "$made"; then
    echo "The page's copies are not what the program writes. Run this again with --update?"
    exit 1
fi
