#include "stridor/integration/kernels/loops.hpp"

#define STRIDOR_ISA baseline
#define STRIDOR_WIDTH 2
#include "stridor/integration/kernels/loops.inl"
