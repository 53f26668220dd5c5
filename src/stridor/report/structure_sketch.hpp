#pragma once

#include "stridor/parameters/case.hpp"

#include <string>

namespace stridor::report {

/// Returns a drawing of a structure of the user's own as SVG: a body whose named contacts rub on a surface that moves
/// under it; of many contacts the first and the last few.
std::string structure_sketch_svg(const parameters::Case& c);

}  // namespace stridor::report
