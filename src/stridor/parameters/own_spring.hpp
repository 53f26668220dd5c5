#pragma once

#include "stridor/base/error.hpp"
#include "stridor/parameters/case.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Springs of an own structure beside its stiffness matrix, whose force need not be linear: rubber that stiffens, a
/// stop, a round body pressed on another, a measured force over deflection.
namespace stridor::parameters {

/// A force over the deflection as measured.
struct ForceTable {
    std::string file{};  // a CSV with the columns deflection and force; empty: the rows stand in the case
    std::vector<double> deflections{};  // [m] rising, shape [row]
    std::vector<double> forces{};       // [N] there, never falling; shape [row]
    bool operator==(const ForceTable&) const = default;
};

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

/// Returns "0: 0, 0.001: 2", the deflection [m] and force [N] of each row; the name of its file where that is not read
/// yet.
std::string force_table_text(const ForceTable& table);

/// Reads rows as text: "0: 0, 1 mm: 2 N". A text without a colon is the name of a CSV file, not opened here. Throws
/// `Error` (input) without a place for rows that are no function, and for forces that fall.
ForceTable parse_force_table(std::string_view text);

/// Throws `Error` (input) without a place for rows that are no function, and for forces that fall.
void expect_rising(const ForceTable& table);

}  // namespace stridor::parameters
