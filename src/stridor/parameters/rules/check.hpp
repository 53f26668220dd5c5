#pragma once

#include "stridor/base/error.hpp"
#include "stridor/parameters/case.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace stridor::parameters {

/// One thing that is wrong with a case, and the field a user would change to mend it.
struct Finding {
    std::string key;  // "contact.kinetic_friction"
    base::Problem problem;
    std::vector<std::string_view> others{};  // keys it depends on besides; empty: it may depend on any
};

/// Returns everything that is wrong with a case beyond the range of each single value: values that contradict each
/// other.
///
/// Empty for a case that can be simulated. A step beyond the stability limit is not looked for here: that needs the
/// system's frequencies (`integration::step_limit`).
std::vector<Finding> findings(const Case& c);

/// Returns what is wrong with one joint and with what all share. Keys are those of a case with one joint.
std::vector<Finding> findings_at(CaseView at);

}  // namespace stridor::parameters
