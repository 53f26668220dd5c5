#pragma once

#include "stridor/advice/design_runner.hpp"
#include "stridor/advice/design_space.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// What lies close to a quiet design: a part is never made as it is drawn. Each quantity that a designer varies is
/// changed alone, by shares of its value, and the nearest change that ends the silence is told.
namespace stridor::advice {

/// By so much each quantity is changed, less and more [1, share of its value; of one that is zero, of its usual range].
inline constexpr std::array near_steps{0.001, 0.002, 0.0035, 0.005, 0.0075, 0.01, 0.02, 0.035, 0.05};

/// So far is looked [1].
inline constexpr double looked_within = near_steps.back();

/// A change of one quantity with which a quiet design is quiet no more.
struct NearChange {
    std::string key{};
    double relative = 0.0;    // [1] below 0: less of it; share of the value, or of the usual range where that is zero
    double value = 0.0;       // in the field's unit
    DesignVerdict verdict{};  // there
};

/// What was found within `looked_within`; every change has the quantity's own key, of all of them, not of a space's.
struct Neighbourhood {
    std::vector<NearChange> turns{};  // nearest first, at most one to each side of a quantity
};

/// Looks around a quiet design. Both sides of a change that it finds are 0.0005 of the value apart, at most.
Neighbourhood neighbourhood(const DesignSpace& space, DesignRunner& runner);

}  // namespace stridor::advice
