# Looks whether code that a page shows as the program's own stands in the program's sources.
#
#     awk -f check_quotes.awk SOURCE... PAGE      PAGE, a .md, is the last
#
# It looks at the blocks ```cpp below a heading whose text says "which Stridor has", line by line, without margins.
function trimmed(line) {
    gsub(/^[ \t]+|[ \t]+$/, "", line)
    return line
}
FILENAME !~ /\.md$/ { sources[trimmed($0)] = 1; next }
/^## / { is_own = 0 }
/which Stridor has/ { is_own = 1 }
/which Stridor$/ { is_own = 1 }
trimmed($0) == "```cpp" { in_code = 1; next }
trimmed($0) == "```" { in_code = 0; next }
in_code && is_own && trimmed($0) != "" {
    count++
    if (!(trimmed($0) in sources)) { print FILENAME ":" FNR ": no source has " trimmed($0); failed = 1 }
}
END {
    if (count == 0) { print "no code was looked at"; failed = 1 }
    exit failed
}
