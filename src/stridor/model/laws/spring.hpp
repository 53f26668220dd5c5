#pragma once

#include "stridor/model/laws/measured_curve.hpp"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <span>
#include <variant>
#include <vector>

/// Springs whose force is not linear in their elongation e [m]. They push with -F(e) along their direction. A law is a
/// struct of its numbers with F [N], its slope F' [N/m], what it stores [J], the corners between which F is one
/// analytic function, and the power series of F along a motion. The engines hold a `SpringLaw` and know no law.
namespace stridor::model {

/// What the recurrences of a law know when they find the next coefficient of its force along a motion.
struct SpringTerms {
    std::span<const double> elongation{};  // [m] its last is of the wanted power
    SmoothStretch stretch{};               // whose function is expanded
    std::array<JetSeries, 3> own{};        // series that the law keeps beside it
};

/// A force that grows with the cube of the elongation, as rubber's does that stiffens:
///
///     F = k3 e³
///
/// Source: G. Duffing 1918, Erzwungene Schwingungen bei veränderlicher Eigenfrequenz.
struct CubicSpring {
    double cubic = 0.0;  // [N/m³] k3; below 0: it softens

    double force(double e) const { return cubic * e * e * e; }
    double stiffness(double e) const { return 3.0 * cubic * e * e; }
    double energy(double e) const { return 0.25 * cubic * (e * e) * (e * e); }
    std::vector<double> corners() const { return {}; }
    double jet(SpringTerms& terms) const;
    bool operator==(const CubicSpring&) const = default;
};

/// A force that pushes on one side only, with a power p of how far the spring is pressed:
///
///     F = F_1 ((e - g)/d_1)^p where e > g, else 0
///
/// p = 3/2 is Hertz' contact of two round bodies, p = 1 a stop with a linear bumper. Next to e = g a power that is no
/// whole number has no power series. Up to `blunt` beyond it the force is x² ((3 - p) + (p - 2) x) times that at
/// `blunt`, x = (e - g)/blunt: it goes on with the same value and slope.
/// Source: H. Hertz 1881, Über die Berührung fester elastischer Körper.
struct PowerSpring {
    double reference_force = 0.0;       // [N] F_1 >= 0
    double reference_deflection = 1.0;  // [m] d_1 > 0
    double exponent = 1.5;              // [1] 1 <= p <= 3
    double gap = 0.0;                   // [m] g
    double blunt = 0.0;                 // [m] 0 where p is whole, else above 0

    double force(double e) const;
    double stiffness(double e) const;
    double energy(double e) const;
    std::vector<double> corners() const;
    double jet(SpringTerms& terms) const;
    bool operator==(const PowerSpring&) const = default;
};

/// A force as measured, through the rows of a table. Beyond its ends it goes on straight.
struct TableSpring {
    std::shared_ptr<const MeasuredCurve> curve;  // [N] over [m], never falling; shared: it is never changed
    std::vector<double> stored;                  // [J] from the first row to each, shape [row]

    double force(double e) const;
    double stiffness(double e) const;
    double energy(double e) const;
    std::vector<double> corners() const { return curve->places; }
    double jet(SpringTerms& terms) const;
    bool operator==(const TableSpring& other) const { return *curve == *other.curve; }
};

/// Returns the spring through the rows of a table: elongations [m], rising, and forces [N].
TableSpring table_spring(const std::vector<double>& elongations, const std::vector<double>& forces,
                         parameters::Interpolation interpolation);

/// Returns Hertz' law or another power, blunt over a length that changes nothing which is measured: a millionth of the
/// deflection under `usual_force` [N], or of the reference one if that is 0.
PowerSpring power_spring(double reference_force, double reference_deflection, double exponent, double gap,
                         double usual_force);

using SpringLaw = std::variant<CubicSpring, PowerSpring, TableSpring>;

/// A spring beside the stiffness matrix. Its elongation is e = e0 + d.u.
struct Spring {
    Eigen::VectorXd direction;  // [1] d, shape [dof]
    SpringLaw law{};
    double rest = 0.0;  // [m] e0, its elongation where u = 0
};

/// Returns force [N], its slope [N/m] and what is stored [J] at an elongation e [m].
inline double force_of(const SpringLaw& law, double e) {
    return std::visit([&](const auto& each) { return each.force(e); }, law);
}
inline double stiffness_of(const SpringLaw& law, double e) {
    return std::visit([&](const auto& each) { return each.stiffness(e); }, law);
}
inline double energy_of(const SpringLaw& law, double e) {
    return std::visit([&](const auto& each) { return each.energy(e); }, law);
}

/// Returns the elongations around e [m] over which the force is one analytic function; within `rounding` [m] of a
/// corner, those on that side.
SmoothStretch elongation_stretch(const SpringLaw& law, double e, double rounding, CornerSide side);

/// Returns the next coefficient of the force [N] along a motion, from those of the elongation up to it. Its recurrences
/// use +, -, * and / in a fixed order: the same bits on every machine.
inline double next_force(const SpringLaw& law, SpringTerms& terms) {
    return std::visit([&](const auto& each) { return each.jet(terms); }, law);
}

/// Returns the elongation [m] at which `linear` [N/m] and the spring together push with a force [N]; infinite where
/// they never do.
double elongation_under(const SpringLaw& law, double linear, double force);

}  // namespace stridor::model
