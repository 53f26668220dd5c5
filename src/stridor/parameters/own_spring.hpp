#pragma once

#include "stridor/base/error.hpp"
#include "stridor/parameters/case.hpp"

#include <optional>
#include <string>
#include <vector>

/// Springs of an own structure beside its stiffness matrix, whose force need not be linear: rubber that stiffens, a
/// stop, a round body pressed on another, a measured force over deflection.
namespace stridor::parameters {

/// A spring of an own structure. It pushes with -F(e) along its direction d, e = e0 + d.u.
struct OwnSpring {
    std::string name{};               // "lip"
    std::vector<double> direction{};  // [1] d, shape [row]
    double stiffness = 0.0;           // [N/m] linear part of F, which joins the stiffness matrix
    double cubic = 0.0;               // [N/m^3] k3 of F = k3 e³
    double force = 0.0;               // [N] F_1 of F = F_1 ((e - g)/d_1)^p where e > g
    double deflection = 0.0;          // [m] d_1
    double exponent = 1.5;            // [1] p
    double gap = 0.0;                 // [m] g
    ForceTable table{};               // F as measured
    Interpolation interpolation = Interpolation::cubic;
    double preload_share = 0.0;  // [1] of contact.preload that it bears at rest: e0 follows from it
};

/// What the force of a spring is, beside its linear part.
enum class SpringKind { linear, cubic, power, table };
SpringKind kind_of(const OwnSpring& spring);

/// Returns what is wrong with a spring; nothing if it has one force that makes sense.
std::optional<base::Problem> problem_of(const OwnSpring& spring);

}  // namespace stridor::parameters
