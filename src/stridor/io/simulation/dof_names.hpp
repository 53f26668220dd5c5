#pragma once

#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::io {

/// What moves in the degrees of freedom of the rubbing system, after "displacement".
inline constexpr std::array<std::string_view, 3> dof_sentences{
    "of the joint along the plate", "of the joint across the plate", "of the plate across the contact"};

/// Names of the degrees of freedom in files: x1, y1, y2 of the rubbing system; of several joints x and y with their
/// names, then y_plate; of an own structure its rows.
inline std::vector<std::string> dof_names(const parameters::Case& c) {
    if (c.own_structure) return c.own_structure->row;
    if (c.further_joints.empty()) return {"x1", "y1", "y2"};
    std::vector<std::string> names;
    for (std::size_t k = 0; k < parameters::joint_count(c); ++k)
        for (const std::string_view direction : {"x_", "y_"})
            names.push_back(std::string(direction) + parameters::joint_name(c, k));
    names.emplace_back("y_plate");
    return names;
}

/// The same, with the outputs of an own structure where they are in the record, or u1, u2, ... where it is of another
/// structure.
inline std::vector<std::string> dof_names(const parameters::Case& c, std::size_t count) {
    std::vector<std::string> names = dof_names(c);
    if (names.size() == count) return names;
    if (c.own_structure && names.size() + c.own_structure->outputs.size() == count) {
        for (const parameters::OwnOutput& output : c.own_structure->outputs)
            names.push_back(output.name);
        return names;
    }
    names.clear();
    for (std::size_t k = 1; k <= count; ++k)
        names.push_back("u" + std::to_string(k));
    return names;
}

}  // namespace stridor::io
