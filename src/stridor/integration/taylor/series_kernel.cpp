#include "stridor/integration/taylor/series_kernel.hpp"

#include "stridor/base/check.hpp"

namespace stridor::integration {

namespace baseline {
extern const SeriesKernel loops_of_series;
}
#if STRIDOR_X86
namespace avx2 {
extern const SeriesKernel loops_of_series;
}
namespace avx512 {
extern const SeriesKernel loops_of_series;
}
#endif

const SeriesKernel& series_kernel(InstructionSet set) {
    STRIDOR_EXPECT(is_available(set));
#if STRIDOR_X86
    if (set == InstructionSet::avx512) return avx512::loops_of_series;
    if (set == InstructionSet::avx2) return avx2::loops_of_series;
#endif
    return baseline::loops_of_series;
}

}  // namespace stridor::integration
