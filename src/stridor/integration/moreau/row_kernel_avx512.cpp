#include "stridor/integration/moreau/row_kernel.hpp"

#define STRIDOR_ISA avx512
#include "stridor/integration/moreau/row_kernel.inl"
