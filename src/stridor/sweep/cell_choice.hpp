#pragma once

#include "stridor/sweep/study.hpp"

#include <optional>
#include <string>

namespace stridor::sweep {

/// A cell as users name it: "x=20 N,y=0.6", optionally with "direction=going".
struct CellChoice {
    std::string text;  // as it was written, for messages
    std::string x;     // "20 N"
    std::string y;
    std::optional<parameters::Direction> direction{};
};

/// Reads a cell's name. Throws `Error` (input) for any other text.
CellChoice parse_cell(const std::string& text);

/// Returns the cell nearest to the values, on its axes' own scales, in the named direction or the study's first. Throws
/// `Error` (input) for values outside the chart and for a direction it does not have.
CellPlace nearest_cell(const Study& study, const CellChoice& choice);

/// Returns the values of a cell: "contact.preload = 20.7 N, contact.kinetic_friction = 0.59".
std::string cell_words(const Study& study, const CellPlace& place);

/// Returns the short name of a cell, as a user may ask for it: "x=20.74 N,y=0.5949".
std::string cell_name(const Study& study, const CellPlace& place);

}  // namespace stridor::sweep
