#pragma once

#include "stridor/parameters/case.hpp"

#include <span>
#include <string>
#include <variant>

namespace stridor::io {

/// One value that is to stand in a case in place of another.
struct CaseChange {
    std::string name;                         // in any spelling of `parameters::key_called`
    std::variant<double, std::string> value;  // [the field's unit], or as a user would write it: "20 N", "sinusoidal"
};

/// Returns the case that `--set` would make of this one's file with all these changes at once; later ones win. Samples
/// of a drive and matrices that came from files stay as they are: no file is read but one that a change names.
///
/// Throws `Error` (input), without places, for what `read_case` refuses: names that are none, values out of their
/// range, changes that leave something out or contradict what stays.
parameters::Case changed(const parameters::Case& c, std::span<const CaseChange> changes);

}  // namespace stridor::io
