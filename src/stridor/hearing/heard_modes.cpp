#include "stridor/hearing/heard_modes.hpp"

#include "stridor/base/error.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/case_structure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace stridor::hearing {

namespace {

constexpr double samples_a_cycle = 40.0;  // [1] of the highest free mode
constexpr double highest_rate = 1e6;      // [Hz]
constexpr double most_numbers = 1.6e7;    // [1] of all modes: 128 MB
constexpr double most_samples = 524288.0;
constexpr std::size_t least_frame = 64;
constexpr double frames = 4.0;  // [1] of a stretch: more smooth a spectrum, and blur its lines

Eigen::VectorXd weights_of(const sound::Pickup& pickup, Eigen::Index dofs) {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(dofs);
    for (std::size_t k = 0; k < pickup.weights.size(); ++k)
        weights(static_cast<Eigen::Index>(k)) = pickup.weights[k];
    if (pickup.weights.empty())
        weights(pickup.dof == sound::last_dof ? dofs - 1 : static_cast<Eigen::Index>(pickup.dof)) = 1.0;
    return weights;
}

record::TraceRequest trace_of(const parameters::Case& c, const std::vector<double>& frequencies) {
    const double judged = c.run.window * (1.0 - c.verdict.start);
    const double highest = frequencies.empty() ? 0.0 : frequencies.back();
    const double rate = highest > 0.0 ? std::min(samples_a_cycle * highest, highest_rate) : 1e4 / judged;
    const double most =
        std::min(most_samples, most_numbers / static_cast<double>(std::max<std::size_t>(frequencies.size(), 1)));
    record::TraceRequest trace;
    trace.interval = 1.0 / rate;
    trace.to = c.run.duration;
    trace.from = std::max(c.run.duration - judged, c.run.duration - most / rate);
    return trace;
}

// takes the mean away, which is no vibration; what is left of a motion that has died out is none either
void keep_vibration(std::vector<std::vector<double>>& velocities) {
    for (std::vector<double>& velocity : velocities) {
        const double sum = std::accumulate(velocity.begin(), velocity.end(), 0.0);
        const double mean = velocity.empty() ? 0.0 : sum / static_cast<double>(velocity.size());
        for (double& value : velocity)
            value -= mean;
    }
    double most = 0.0;  // [m/s]
    for (std::size_t sample = 0; !velocities.empty() && sample < velocities.front().size(); ++sample) {
        double sum = 0.0;
        for (const std::vector<double>& velocity : velocities)
            sum += velocity[sample];
        most = std::max(most, std::abs(sum));
    }
    if (most > least_motion) return;
    for (std::vector<double>& velocity : velocities)
        std::fill(velocity.begin(), velocity.end(), 0.0);
}

}  // namespace

HeardModes heard_modes(const parameters::Case& c, const AskedMotion& asked, const std::stop_token& stop) {
    if (asked.quantity != signal::MotionQuantity::velocity)
        base::refuse("the modes of an acceleration are not told apart", "the spectrum is of a velocity", "");
    const HeardMotion motion = heard_motion(c, asked, stop);
    const model::Structure structure = model::structure_of(c);
    HeardModes heard{motion_words(motion), analysis::open_modes(structure)};
    const Eigen::MatrixXd rows =
        analysis::modal_rows(heard.modes, structure.mass, weights_of(motion.pickup, structure.mass.rows()));
    std::vector<std::vector<double>> velocities(static_cast<std::size_t>(rows.rows()));
    record::Request request{record::KeepHistory::no, trace_of(c, heard.modes.frequencies)};
    request.trace.taker = [&](const record::Trace& trace) {
        Eigen::VectorXd velocity(rows.cols());
        for (std::size_t sample = 0; sample < trace.time.size(); ++sample) {
            for (Eigen::Index row = 0; row < velocity.size(); ++row)
                velocity(row) = trace.velocity[static_cast<std::size_t>(row)][sample];
            const Eigen::VectorXd parts = rows * velocity;
            for (std::size_t mode = 0; mode < velocities.size(); ++mode)
                velocities[mode].push_back(parts(static_cast<Eigen::Index>(mode)));
        }
    };
    const integration::Motion run = integration::simulate(c, request, stop);
    if (const std::optional<Error> failure = integration::failure(c, run)) throw *failure;
    keep_vibration(velocities);
    const double samples = velocities.empty() ? 0.0 : static_cast<double>(velocities.front().size());
    const auto size = std::max(least_frame, 2 * static_cast<std::size_t>(samples / (frames + 1.0)));
    heard.spectrum = analysis::modal_spectrum(velocities, 1.0 / request.trace.interval, size);
    heard.from = request.trace.from;
    heard.to = request.trace.to;
    return heard;
}

}  // namespace stridor::hearing
