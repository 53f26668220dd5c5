#pragma once

namespace stridor::sound {

/// The top of a parabola.
struct Summit {
    double place = 0.0;  // in steps from the middle value
    double height = 0.0;
};

/// The top of the parabola through a greatest value and its neighbours, at most half a step away; the middle value
/// where the three do not bend down.
Summit parabola_summit(double left, double centre, double right);

}  // namespace stridor::sound
