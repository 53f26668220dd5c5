#pragma once

/// Compiles a function twice, for every x86-64 processor and for those with AVX2, and lets the program take what the
/// machine has. Both give the same bits: the wider set does more numbers at a time, each with the same operations, for
/// fused ones are nowhere allowed (`-ffp-contract=off`). For AVX-512 GCC 12 makes some even so. Put it before functions
/// whose loops are long and independent.
#if defined(__x86_64__) && defined(__ELF__) && !defined(__SANITIZE_THREAD__)
#    define STRIDOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#    define STRIDOR_CLONES
#endif
