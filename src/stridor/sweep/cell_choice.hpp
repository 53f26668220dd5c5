#pragma once

#include "stridor/sweep/study.hpp"

#include <optional>
#include <string>

namespace stridor::sweep {

/// A cell as users name it: "x=20 N,y=0.6", and where it may be named "direction=going".
struct CellChoice {
    std::string text;  // as it was written, for messages
    std::string x;     // "20 N"
    std::string y;
    std::optional<parameters::Direction> direction{};
};

/// Reads a cell's name. Throws `Error` (input) for anything else.
CellChoice parse_cell(const std::string& text);

/// The cell nearest to the values, in its axes' own scales, in the direction named or the study's first. Throws `Error`
/// (input) for values outside the chart and for a direction it does not have.
CellPlace nearest_cell(const Study& study, const CellChoice& choice);

/// "contact.preload = 20.7 N, contact.kinetic_friction = 0.59": the values of a cell.
std::string cell_words(const Study& study, const CellPlace& place);

/// "x=20.74 N,y=0.5949": the same in short, as it can be asked for.
std::string cell_name(const Study& study, const CellPlace& place);

}  // namespace stridor::sweep
