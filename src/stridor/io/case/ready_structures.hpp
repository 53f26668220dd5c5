#pragma once

#include "stridor/parameters/case.hpp"

#include <span>
#include <string_view>

namespace stridor::io {

/// A case with a structure of a builder, ready to start from.
struct ReadyStructure {
    std::string_view name;
    parameters::Case (*make)();
};

/// Returns the ready structures. chain: two equal blocks on a belt, whose slips and sticks have a closed form. string:
/// a bowed string in Helmholtz' motion.
std::span<const ReadyStructure> ready_structures();

}  // namespace stridor::io
