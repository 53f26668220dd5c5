#pragma once

#include "stridor/parameters/case.hpp"

namespace stridor::model {

/// Static friction that grows with the time t for which a contact has stuck, whatever its law of slip:
///
///     logarithmic  |T| <= (mu_s + A ln(1 + t/t_0)) N
///     Kato         |T| <= (mu_inf - (mu_inf - mu_s) exp(-(t/t_0)^m)) N,    0 < m <= 1,    A = mu_inf - mu_s
///
/// Both rise from nothing as a stick begins, ever more slowly: they lie above each of their chords. Kato's gamma is
/// t_0^-m. A slip forgets the rest: its friction is that of its law. Source: E. Rabinowicz 1951, 1958 for the growth;
/// J. H. Dieterich 1972, J. Geophys. Res. 77, 3690, for the logarithm; S. Kato, N. Sato and T. Matsubayashi 1972, J.
/// Lubr. Technol. 94, 234, for the other, with m between 0.36 and 0.67 on lubricated slideways.
struct RestGrowth {
    parameters::RestKind kind = parameters::RestKind::none;
    double growth = 0.0;    // [1] A >= 0
    double time = 1.0;      // [s] t_0 > 0
    double exponent = 1.0;  // [1] m in (0, 1]
    double before = 0.0;    // [s] for which it has stuck when a run begins

    bool operator==(const RestGrowth&) const = default;
};

/// Says whether rest changes anything.
inline bool grows(const RestGrowth& rest) {
    return rest.kind != parameters::RestKind::none;
}

/// Returns what a time of rest [s] adds to the limit of a stick [1].
double grown(const RestGrowth& rest, double rested);

/// Returns the growth of a case's contact.
RestGrowth rest_growth(const parameters::Contact& contact);

}  // namespace stridor::model
