#pragma once

#include <array>
#include <string_view>

namespace stridor::parameters {

/// The two coefficients of a way to slip, as a case calls them. Those that mean nothing for a case do not belong to it
/// (Field::belongs).
struct FrictionKeys {
    std::string_view kinetic, kinetic_symbol;
    std::string_view limit, limit_symbol;
};

inline constexpr std::array friction_keys{
    FrictionKeys{"contact.kinetic_friction", "mu_d", "contact.static_friction", "mu_s"},
    FrictionKeys{"contact.kinetic_friction_coming", "mu_dc", "contact.static_friction_coming", "mu_sc"},
};

}  // namespace stridor::parameters
