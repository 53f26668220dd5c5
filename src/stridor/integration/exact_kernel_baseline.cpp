#include "stridor/integration/exact_kernel.hpp"

#define STRIDOR_ISA baseline
#include "stridor/integration/exact_kernel.inl"
