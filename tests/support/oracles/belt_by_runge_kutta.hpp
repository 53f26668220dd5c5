#pragma once

#include "stridor/model/built/mass_on_belt.hpp"

#include <cstddef>
#include <vector>

/// A mass on a belt with any law of friction, solved by a program of others: an independent answer to the engines.
namespace stridor::support {

/// A change between stick and slip.
struct BeltEvent {
    double time = 0.0;          // [s]
    bool sticks = false;        // from there on
    double displacement = 0.0;  // [m]
};

/// Returns the first events of a mass that starts stuck at x = 0 on a belt of velocity V > 0 [m/s], until `until` [s].
///
/// By the method of Fehlberg, of orders 7 and 8, of Boost's odeint, in numbers of 64 bits of mantissa with a relative
/// error of 1e-16 a step; each event is found by halving the step that passes it, and so is each speed of slip [m/s] at
/// which the law has a corner (rising): the estimate of the method's error does not see it. The belt's own friction is
/// left aside for that of its contact.
std::vector<BeltEvent> belt_by_runge_kutta(const model::Belt& belt, const model::FrictionLaw& law, double V,
                                           double until, const std::vector<double>& corners = {});

}  // namespace stridor::support
