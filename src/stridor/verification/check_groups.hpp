#pragma once

#include "stridor/verification/check.hpp"

#include <span>

namespace stridor::verification {

/// Everything that is verified, cheap groups first; about a second in all.
std::span<const CheckGroup> check_groups();

}  // namespace stridor::verification
