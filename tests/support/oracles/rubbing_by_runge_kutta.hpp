#pragma once

#include "stridor/model/contact_state.hpp"
#include "stridor/model/structure.hpp"

#include <functional>
#include <vector>

/// One contact with any law of friction, solved by a program of others: stick, slip, separation and impact.
namespace stridor::support {

/// A law of friction written anew, T = -sign(w) resistance N. Its functions are analytic through a speed of zero, where
/// a step may try them. The friction state of a slip has the sign of the slip, if it turns.
struct LawAnew {
    using Real = long double;

    std::function<Real(Real rested)> limit{};                // [1] of a stick after a rest [s]; empty: it never sticks
    std::function<Real(Real speed, Real state)> resistance;  // [1] speed in [m/s]
    std::function<Real(Real speed, Real state)> rate{};      // [1/s] of the friction state; empty: the law has none
    std::function<Real(Real speed)> impact{};                // [1] resistance in an impact; empty: that without a state
    Real impact_limit = 0;  // [1] of an impact that leaves no slip, of a law with state
    bool state_turns = false;
    std::vector<Real> corners{};  // [m/s] rising
    Real longest_step = 1;        // [s]
    Real creep_speed = 0;         // [m/s] of a law with a state: below it a slip counts as a stick
};

/// A change of the contact's state.
struct RubbingEvent {
    double time = 0.0;  // [s]
    model::ContactState state = model::ContactState::slip;
};

/// Returns the changes of state of a structure of three rows with one contact, that starts stuck over a surface of
/// velocity V [m/s], until `until` [s]; at most `most` of them.
///
/// By the method of Fehlberg, of orders 7 and 8, of Boost's odeint, in numbers of 64 bits of mantissa with a relative
/// error of 1e-17 a step. What ends a step is found by halving it. The structure's own law of friction is left aside;
/// impacts are plastic, within the friction cone.
std::vector<RubbingEvent> rubbing_by_runge_kutta(const model::Structure& structure, const LawAnew& law, double V,
                                                 double until, std::size_t most);

}  // namespace stridor::support
