#pragma once

#include "stridor/parameters/case.hpp"

#include <array>
#include <string_view>

namespace stridor::parameters {

/// The four columns of Table 1 (Elmaian et al. 2012), by what they are named after.
enum class PaperCase { squeal, squeak, creak, quiet };

inline constexpr std::array<std::string_view, 4> paper_case_names{"squeal", "squeak", "creak", "quiet"};

/// Returns a column of Table 1: sinusoidal drive of 4 mm at 5 Hz, 1 s, started at rest, computed with h = 1e-7 s.
Case paper_case(PaperCase which);

}  // namespace stridor::parameters
