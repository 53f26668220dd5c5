#pragma once

#include "stridor/base/json.hpp"
#include "stridor/io/simulation/friction_test.hpp"

namespace stridor::io {

/// Returns what a trace was measured with as an object of a JSON document, and puts its units.
base::Json test_object(const FrictionTest& test, base::Json& units);

}  // namespace stridor::io
