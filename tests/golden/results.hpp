#pragma once

#include "stridor/integration/kernels/exact_kernel.hpp"

#include <string>
#include <vector>

/// Results of every kind, with all their bits: what no change of a compiler, a flag or a sum may move unseen.
namespace stridor::golden {

/// One result.
struct Result {
    std::string name;     // "squeal.exact"
    std::string values;   // "NAME VALUE" lines, numbers in hexadecimal: each has all its bits
    std::string extract;  // what a reader looks at first, in one line
};

/// All of them, the exact engine's loops by this instruction set.
std::vector<Result> results(integration::InstructionSet set);

}  // namespace stridor::golden
