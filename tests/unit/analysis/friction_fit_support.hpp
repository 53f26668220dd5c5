#pragma once

#include "stridor/parameters/case.hpp"
#include "support/counter_random.hpp"

#include <cstddef>
#include <cstdlib>
#include <string_view>

/// What the tests of fits to traces share.
namespace stridor::analysis {

/// Returns how many traces of each law are made: so many, or STRIDOR_FIT_TRACES in the environment.
inline std::size_t fitted_traces(std::size_t usual) {
    const char* const asked = std::getenv("STRIDOR_FIT_TRACES");
    return asked != nullptr ? static_cast<std::size_t>(std::atol(asked)) : usual;
}

/// Returns a number of nearly a normal distribution, of variance 1.
inline double normal(support::CounterRandom& random) {
    double sum = -6.0;
    for (int k = 0; k < 12; ++k)
        sum += random.between(0.0, 1.0);
    return sum;
}

/// Returns the number of a contact that has a symbol.
inline double true_value(const parameters::Contact& contact, std::string_view symbol) {
    if (symbol == "mu_s") return contact.static_friction;
    if (symbol == "mu_d") return contact.kinetic_friction;
    if (symbol == "s_mu") return contact.friction_slope;
    return contact.stribeck_velocity;
}

}  // namespace stridor::analysis
