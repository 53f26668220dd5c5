#!/bin/sh
# Finds calls of the C library's elementary functions where a sound's verdict is made.
#
#     check_libm.sh SRC
#
# Their last bits depend on the machine's library and processor, and a figure on a threshold falls on either side of it.
# `base/elementary.hpp` and `base/decibels.hpp` have such functions with the same bits everywhere. A square root, a
# remainder and roundings are exact, and may be called. Comments are not looked at.
set -eu

modules='signal sound classification hearing'
cd "$1/stridor"
ls -d $modules >/dev/null
find $modules -type f \( -name '*.hpp' -o -name '*.cpp' \) | LC_ALL=C sort |
    LC_ALL=C awk '
BEGIN {
    names = "(log|log2|log10|log1p|exp|exp2|expm1|pow|cbrt|hypot|sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|" \
        "asinh|acosh|atanh|erf|erfc|tgamma|lgamma|polar|arg|cyl_bessel_[a-z])[fl]? *\\("
}

{
    file = $0
    number = 0
    files++
    while ((getline line < file) > 0) {
        number++
        sub(/\/\/.*/, "", line)
        if (line !~ "std::" names && line !~ "(^|[^A-Za-z0-9_:.>])" names) continue
        printf "%s:%d calls the C library (its last bits depend on the machine). ", file, number
        print "Take base/elementary.hpp?"
        problems++
    }
    close(file)
}

END {
    if (!files) print "There are no sources to check."
    exit !files || problems > 0
}'
