#include "stridor/integration/moreau/row_kernel.hpp"

#include "stridor/base/check.hpp"

namespace stridor::integration {

namespace baseline {
extern const RowKernel loops_of_rows;
}
#if STRIDOR_X86
namespace avx2 {
extern const RowKernel loops_of_rows;
}
namespace avx512 {
extern const RowKernel loops_of_rows;
}
#endif

const RowKernel& row_kernel(InstructionSet set) {
    STRIDOR_EXPECT(is_available(set));
#if STRIDOR_X86
    if (set == InstructionSet::avx512) return avx512::loops_of_rows;
    if (set == InstructionSet::avx2) return avx2::loops_of_rows;
#endif
    return baseline::loops_of_rows;
}

}  // namespace stridor::integration
