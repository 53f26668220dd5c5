#!/bin/sh
# Every relative link of the documentation leads to a file: docs_links_test.sh SOURCE_FOLDER
set -u
cd "$1" || exit 2

failures=0
links=0
for page in README.md CHANGELOG.md $(find docs -name '*.md' | LC_ALL=C sort); do
    # [text](target), several in a line, pictures too, outside of fenced blocks; anchors and web addresses are left out
    for target in $(awk '
        /^[ ]*```/ { is_code = !is_code; next }
        is_code { next }
        {
            text = $0
            while (match(text, /\]\([^)]*\)/)) {
                print substr(text, RSTART + 2, RLENGTH - 3)
                text = substr(text, RSTART + RLENGTH)
            }
        }' "$page" | sed -e 's/#.*//' -e '/^[a-z]*:/d' -e '/^$/d'); do
        links=$((links + 1))
        [ -e "$(dirname "$page")/$target" ] && continue
        failures=$((failures + 1))
        echo "$page: there is no $target"
    done
done
echo "$links links, $failures broken"
[ "$links" -gt 0 ] && [ "$failures" -eq 0 ]
