// All inner loops of the engines for one instruction set: this file is compiled once with STRIDOR_ISA and STRIDOR_WIDTH
// for each, in a namespace of its own, so that no inline function is shared between sets.

#include "stridor/integration/kernels/exact_kernel.inl"
#include "stridor/integration/kernels/row_kernel.inl"
#include "stridor/integration/kernels/series_kernel.inl"

namespace stridor::integration::STRIDOR_ISA {

extern const Loops loops;
const Loops loops{{glide<2>, leap<2>, look, combine, root, move, apply, add_part<2>},
                  {glide<3>, leap<3>, look, combine, root, move, apply, add_part<3>},
                  {multiply, combine, subtract},
                  {expand, evaluate, evaluate_state}};

}  // namespace stridor::integration::STRIDOR_ISA
