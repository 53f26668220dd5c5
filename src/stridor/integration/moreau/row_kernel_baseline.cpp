#include "stridor/integration/moreau/row_kernel.hpp"

#define STRIDOR_ISA baseline
#include "stridor/integration/moreau/row_kernel.inl"
