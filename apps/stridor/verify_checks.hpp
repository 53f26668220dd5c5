#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stridor::app {

/// One number held against a closed form or a published value.
struct Check {
    std::string name;
    double expected = 0.0;
    double computed = 0.0;
    double tolerance = 0.0;  // absolute
    bool passes() const;
};

/// Checks of one kind, and where the expected numbers come from.
struct CheckGroup {
    std::string_view title;
    std::string_view source;
    std::vector<Check> (*run)();
};

/// Everything `stridor verify` computes, cheap groups first.
const std::vector<CheckGroup>& check_groups();

}  // namespace stridor::app
