#include "stridor/integration/kernels/loops.hpp"

#include "stridor/base/check.hpp"

namespace stridor::integration {

namespace baseline {
extern const Loops loops;
}
#if STRIDOR_X86
namespace avx2 {
extern const Loops loops;
}
namespace avx512 {
extern const Loops loops;
}
#endif

namespace {

const Loops& loops_of(InstructionSet set) {
    STRIDOR_EXPECT(is_available(set));
#if STRIDOR_X86
    if (set == InstructionSet::avx512) return avx512::loops;
    if (set == InstructionSet::avx2) return avx2::loops;
#endif
    return baseline::loops;
}

}  // namespace

const Kernel& kernel(InstructionSet set, int dofs) {
    STRIDOR_EXPECT(dofs == 2 || dofs == 3);
    return dofs == 2 ? loops_of(set).exact_2 : loops_of(set).exact_3;
}

const RowKernel& row_kernel(InstructionSet set) {
    return loops_of(set).rows;
}

const SeriesKernel& series_kernel(InstructionSet set) {
    return loops_of(set).series;
}

}  // namespace stridor::integration
