#pragma once

#include "stridor/parameters/case.hpp"

#include <string>

namespace stridor::report {

/// Returns the rubbing system of a case as an SVG picture (Elmaian et al. 2012, Figure 2): the joint on its springs and
/// dashpots at the incidence angle, pressed on the plate that moves under it. Several joints stand side by side, with
/// their names. Drawn in the colour of the text around it.
std::string sketch_svg(const parameters::Case& c);

}  // namespace stridor::report
