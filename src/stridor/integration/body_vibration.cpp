#include "stridor/integration/body_vibration.hpp"

#include <algorithm>

namespace stridor::integration {

void add_vibration(const model::Structure& structure, const Eigen::Ref<const Eigen::VectorXd>& speed, double duration,
                   std::vector<record::Vibration>& vibration) {
    const auto body = [&](std::size_t channel) {
        return structure.body.empty() ? static_cast<int>(channel) : structure.body[channel];
    };
    for (std::size_t first = 0, end = 0; first < vibration.size(); first = end) {
        double whole = 0.0;
        for (end = first; end < vibration.size() && body(end) == body(first); ++end) {
            const double square = speed(static_cast<Eigen::Index>(end)) * speed(static_cast<Eigen::Index>(end));
            vibration[end].square_time += duration * square;
            whole += square;
        }
        for (std::size_t channel = first; channel < end; ++channel)
            vibration[channel].peak_square = std::max(vibration[channel].peak_square, whole);
    }
}

}  // namespace stridor::integration
