#pragma once

#include <vector>

namespace stridor::integration {

/// What the engines' inner loops are compiled for.
enum class InstructionSet { baseline, avx2, avx512 };

/// Returns whether this machine has the instruction set.
bool is_available(InstructionSet set);

/// Returns those of this machine, the baseline first, the widest last.
std::vector<InstructionSet> available_instruction_sets();

/// Returns the widest this machine has.
InstructionSet widest_instruction_set();

}  // namespace stridor::integration
