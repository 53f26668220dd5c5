#pragma once

#include "stridor/classification/verdict.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/parameters/case.hpp"

#include <string>
#include <vector>

namespace stridor::console {

/// Returns a run and its verdicts: what drives it, the table of phases, why each is called so.
std::string simulation_text(const parameters::Case& c, const integration::Motion& motion,
                            const std::vector<classification::Verdict>& verdicts);

}  // namespace stridor::console
