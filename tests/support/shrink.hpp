#pragma once

#include "stridor/parameters/case.hpp"

#include <functional>
#include <string>

namespace stridor::support {

/// The plainest case that still fails: each field has the paper's squeal case's value, or few digits, unless the
/// failure needs what it is.
///
/// `fails` is asked of valid cases only. What is returned fails as long as `c` does.
parameters::Case shrunk(parameters::Case c, const std::function<bool(const parameters::Case&)>& fails);

/// The command that runs a case that differs from the paper's squeal case in some fields.
std::string command_of(const parameters::Case& c);

}  // namespace stridor::support
