#pragma once

#include "stridor/model/structure.hpp"
#include "stridor/parameters/rules/engines.hpp"

namespace stridor::integration {

/// Refuses a structure that asks for what the method cannot solve, by the table of `parameters/rules/engines`: throws
/// `Error` (input) with its name.
void expect_solvable(const model::Structure& structure, parameters::Method method);

}  // namespace stridor::integration
