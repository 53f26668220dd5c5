#!/bin/sh
# No product and sum of a program are one fused instruction, which rounds once: fused_test.sh OBJDUMP FILE...
#
# GCC 12 makes one of the products and sums of neighbouring lanes in spite of -ffp-contract=off, for instructions that
# have it (AVX-512, FMA).
set -u
objdump=$1
shift

failures=0
for file in "$@"; do
    "$objdump" -d --no-show-raw-insn -C "$file" | awk -v file="$file" '
        />:$/ { place = $0 }
        /vfn?m(add|sub)/ { print file ": " place " " $0; count++ }
        END { if (NR < 1000) { print file ": nothing was looked at"; exit 1 } exit count > 0 }' ||
        failures=$((failures + 1))
done
[ "$failures" -eq 0 ]
