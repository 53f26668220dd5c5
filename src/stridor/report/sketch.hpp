#pragma once

#include "stridor/parameters/case.hpp"

#include <string>

namespace stridor::report {

/// The rubbing system of a case as an SVG picture (Elmaian et al. 2012, Figure 2): the joint on its
/// springs and dashpots at the incidence angle, pressed on the plate that moves under it; of several joints each beside
/// the one before, with its name. Drawn in the
/// colour of the text around it.
std::string sketch_svg(const parameters::Case& c);

}  // namespace stridor::report
