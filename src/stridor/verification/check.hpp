#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What this program must reproduce, with the code that computes it: closed forms, published numbers, stored digits.
/// `stridor verify` and the tests hold the engines against the same ones.
namespace stridor::verification {

/// One number held against a closed form or a published value.
struct Check {
    std::string name;
    double expected = 0.0;
    double computed = 0.0;
    double tolerance = 0.0;  // absolute
    /// Does computed lie within the tolerance of expected?
    bool passes() const;
};

/// Checks of one kind, and where the expected numbers come from.
struct CheckGroup {
    std::string_view title;
    std::string_view source;
    std::vector<Check> (*run)();
};

}  // namespace stridor::verification
