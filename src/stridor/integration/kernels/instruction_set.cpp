#include "stridor/integration/kernels/instruction_set.hpp"

namespace stridor::integration {

bool is_available(InstructionSet set) {
#if STRIDOR_X86
    if (set == InstructionSet::avx512) return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
    if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2");
#endif
    return set == InstructionSet::baseline;
}

std::vector<InstructionSet> available_instruction_sets() {
    std::vector<InstructionSet> sets;
    for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
        if (is_available(set)) sets.push_back(set);
    return sets;
}

InstructionSet widest_instruction_set() {
    static const InstructionSet widest = available_instruction_sets().back();
    return widest;
}

}  // namespace stridor::integration
