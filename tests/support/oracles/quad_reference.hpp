#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"

#include <vector>

namespace stridor::support {

/// What friction does during an impact.
enum class ImpactFriction {
    cone,  // the tangential impulse obeys the same cone as the forces: it stops the slip if it can
    none,  // impulse along the normal only
};

struct QuadOptions {
    ImpactFriction impact_friction = ImpactFriction::cone;
    double restitution = 0.0;        // [1] e in [0, 1): g' after the impact = -e g' before
    double settle_velocity = 1e-12;  // [m/s] a rebound slower than this is none: ends the geometric series of bounces
    double step_share = 1.0;         // [1] in (0, 1]: of the step the series allows; a result must not depend on it
    std::size_t most_changes =
        1000;  // [1] in a row without a full step in between; more are an error that names the time
};

/// One meeting of the surfaces.
struct QuadImpact {
    double time = 0.0;              // [s]
    double gap_velocity = 0.0;      // [m/s] g' before, negative
    double slip_before = 0.0;       // [m/s] w
    double slip_after = 0.0;        // [m/s] w
    double rebound_velocity = 0.0;  // [m/s] g' after
};

/// A motion of the rubbing system, exact to the digits of double precision until chaos has amplified 1e-30 to them.
struct QuadMotion {
    record::ContactHistory history;
    std::vector<QuadImpact> impacts;
};

/// Runs a case (constant or sinusoidal drive, started at rest or stuck) in quad precision: Taylor series within a
/// contact state, every change of state isolated with certainty. It shares no line with src/stridor/model or
/// src/stridor/integration.
///
/// A separation that ends in an impact and begins again at once is one separation in the history and two in nothing but
/// `impacts`. Throws std::invalid_argument for other drives and starts, std::runtime_error where the contact chatters.
QuadMotion quad_reference(const parameters::Case& c, const QuadOptions& options = {});

}  // namespace stridor::support
