#include "stridor/integration/exact_kernel.hpp"

#define STRIDOR_ISA avx512
#include "stridor/integration/exact_kernel.inl"
