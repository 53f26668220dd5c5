#include "stridor/analysis/friction/stretches.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace stridor::analysis {

namespace {

constexpr std::size_t fewest_samples = 16;

void require_finite(std::span<const double> values, const char* name) {
    for (std::size_t k = 0; k < values.size(); ++k)
        if (!std::isfinite(values[k]))
            base::refuse(std::string("sample ") + std::to_string(k + 1) + " of the " + name + " is not a number",
                         "figures made from it would not be either", "Cut it out of the file?");
}

void add_stretch(std::vector<ForceStretch>& stretches, const ForceStretch& stretch) {
    if (stretch.to >= stretch.from + 3) stretches.push_back(stretch);
}

std::vector<ForceStretch> stretches_by_velocity(std::span<const double> velocity, double share) {
    const double least = share * quantile(magnitudes(velocity), 0.95);
    std::vector<ForceStretch> stretches;
    std::size_t begin = 0;
    int direction = 0;
    for (std::size_t k = 0; k <= velocity.size(); ++k) {
        const double v = k < velocity.size() ? velocity[k] : 0.0;
        const int now = std::abs(v) <= least || least == 0.0 ? 0 : (v > 0.0 ? 1 : -1);
        if (now == direction) continue;
        if (direction != 0) add_stretch(stretches, {begin, k, direction});
        begin = k;
        direction = now;
    }
    return stretches;
}

// a reversal lies where the force passed zero last before the other sign grew large
std::vector<ForceStretch> stretches_by_force(std::span<const double> r, double share) {
    const double least = share * quantile(magnitudes(r), 0.95);
    std::vector<ForceStretch> stretches;
    std::size_t begin = 0, zero = 0;
    int direction = 0;
    for (std::size_t k = 0; k < r.size(); ++k) {
        if (!std::isfinite(r[k])) continue;
        if (k > 0 && (r[k] > 0.0) != (r[k - 1] > 0.0)) zero = k;
        const int now = std::abs(r[k]) < least || least == 0.0 ? 0 : (r[k] > 0.0 ? 1 : -1);
        if (now == 0 || now == direction) continue;
        if (direction != 0) {
            add_stretch(stretches, {begin, zero, direction});
            begin = zero;
        }
        direction = now;
    }
    if (direction != 0) add_stretch(stretches, {begin, r.size(), direction});
    return stretches;
}

}  // namespace

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const std::size_t place = base::whole_near(share * static_cast<double>(values.size() - 1), values.size() - 1);
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
    return values[place];
}

std::vector<double> magnitudes(std::span<const double> values) {
    std::vector<double> result;
    for (const double value : values)
        if (std::isfinite(value)) result.push_back(std::abs(value));
    return result;
}

void expect_valid(const FrictionMeasurement& m) {
    if (!(m.preload > 0.0) || !std::isfinite(m.preload))
        base::refuse("a preload of " + base::shortest(m.preload) + " N is none", "it must be positive", "");
    if (m.force.size() < fewest_samples)
        base::refuse("the friction force has " + std::to_string(m.force.size()) + " samples",
                     "at least " + std::to_string(fewest_samples) + " are needed", "");
    for (const auto& [values, name] : {std::pair{m.velocity, "velocity"}, {m.normal_force, "normal force"}})
        if (!values.empty() && values.size() != m.force.size())
            base::refuse(std::string("the ") + name + " has another length than the friction force", "", "");
    require_finite(m.force, "friction force");
    require_finite(m.velocity, "velocity");
    require_finite(m.normal_force, "normal force");
}

std::vector<double> force_ratios(const FrictionMeasurement& m, const FrictionTraceOptions& options) {
    std::vector<double> r(m.force.size());
    for (std::size_t k = 0; k < r.size(); ++k) {
        const double N = m.normal_force.empty() ? m.preload : m.normal_force[k];
        r[k] = N > options.open_contact * m.preload ? m.force[k] / N : std::numeric_limits<double>::quiet_NaN();
    }
    return r;
}

std::vector<ForceStretch> force_stretches(const FrictionMeasurement& measurement, std::span<const double> r,
                                          const FrictionTraceOptions& options) {
    const std::vector<ForceStretch> stretches =
        measurement.velocity.empty() ? stretches_by_force(r, options.reversal)
                                     : stretches_by_velocity(measurement.velocity, options.moving_velocity);
    if (std::none_of(r.begin(), r.end(), [](double ratio) { return std::isfinite(ratio); }))
        base::refuse("the contact is separated all the time", "its normal force is zero, or far below the preload",
                     "Is the preload right, and is that channel the normal force?");
    if (stretches.empty())
        base::refuse("nothing slides in this trace",
                     measurement.velocity.empty() ? "its friction force is zero" : "its velocity is zero", "");
    return stretches;
}

}  // namespace stridor::analysis
