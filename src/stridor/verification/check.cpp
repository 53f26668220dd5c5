#include "stridor/verification/check.hpp"

#include <cmath>

namespace stridor::verification {

bool Check::passes() const {
    return std::abs(computed - expected) <= tolerance;
}

}  // namespace stridor::verification
