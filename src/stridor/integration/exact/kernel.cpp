#include "stridor/integration/exact/kernel.hpp"

#include "stridor/base/check.hpp"

namespace stridor::integration {

namespace baseline {
extern const Kernel kernel_2, kernel_3;
}
#if STRIDOR_X86
namespace avx2 {
extern const Kernel kernel_2, kernel_3;
}
namespace avx512 {
extern const Kernel kernel_2, kernel_3;
}
#endif

const Kernel& kernel(InstructionSet set, int dofs) {
    STRIDOR_EXPECT(is_available(set) && (dofs == 2 || dofs == 3));
#if STRIDOR_X86
    if (set == InstructionSet::avx512) return dofs == 2 ? avx512::kernel_2 : avx512::kernel_3;
    if (set == InstructionSet::avx2) return dofs == 2 ? avx2::kernel_2 : avx2::kernel_3;
#endif
    return dofs == 2 ? baseline::kernel_2 : baseline::kernel_3;
}

}  // namespace stridor::integration
