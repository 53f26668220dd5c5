#include "stridor/integration/exact/kernel.hpp"

#define STRIDOR_ISA baseline
#define STRIDOR_WIDTH 2
#include "stridor/integration/exact/kernel.inl"
