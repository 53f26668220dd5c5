#pragma once

#include "stridor/model/rubbing_system.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::io {

/// What moves in the degrees of freedom of the rubbing system, after "displacement".
inline constexpr std::array<std::string_view, 3> dof_sentences{
    "of the joint along the plate", "of the joint across the plate", "of the plate across the contact"};

/// Names of the degrees of freedom in files: x1, y1, y2 of the rubbing system; u1, u2, ... of any other structure.
inline std::vector<std::string> dof_names(std::size_t count) {
    if (count == static_cast<std::size_t>(model::rubbing_system_dofs)) return {"x1", "y1", "y2"};
    std::vector<std::string> names;
    for (std::size_t k = 1; k <= count; ++k)
        names.push_back("u" + std::to_string(k));
    return names;
}

}  // namespace stridor::io
