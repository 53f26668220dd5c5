#include "stridor/sound/parabola.hpp"

#include <algorithm>

namespace stridor::sound {

Summit parabola_summit(double left, double centre, double right) {
    const double curvature = left - 2.0 * centre + right;
    if (!(curvature < 0.0)) return {0.0, centre};
    const double shift = std::clamp(0.5 * (left - right) / curvature, -0.5, 0.5);
    return {shift, centre - 0.25 * (left - right) * shift};
}

}  // namespace stridor::sound
