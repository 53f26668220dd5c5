#pragma once

#include "stridor/model/rubbing_system.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace stridor::io {

/// Names of the degrees of freedom in files: x1, y1, y2 of the rubbing system; u1, u2, ... of any other structure.
inline std::vector<std::string> dof_names(std::size_t count) {
    if (count == static_cast<std::size_t>(model::rubbing_system_dofs)) return {"x1", "y1", "y2"};
    std::vector<std::string> names;
    for (std::size_t k = 1; k <= count; ++k)
        names.push_back("u" + std::to_string(k));
    return names;
}

}  // namespace stridor::io
