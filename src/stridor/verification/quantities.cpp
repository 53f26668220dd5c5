#include "stridor/verification/quantities.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/analysis/stability_scan.hpp"
#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/model/contact_state.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/record/trace.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace stridor::verification {

namespace {

using parameters::Case;

integration::Motion motion_of(const Case& c, const record::Request& request = {}) {
    integration::Motion motion = integration::simulate(c, request);
    if (const std::optional<Error> error = integration::failure(c, motion)) throw Error(*error);
    return motion;
}

record::Request over_window(const Case& c, double interval) {
    record::Request request;
    request.trace = {.from = c.run.duration - c.run.window, .to = c.run.duration, .interval = interval};
    return request;
}

// t.u of a sample
double position(const Case& c, const record::Trace& trace, std::size_t sample) {
    const std::vector<double> tangent = parameters::point_weights(c, 0, parameters::PointAxis::sliding);
    double sum = 0.0;
    for (std::size_t row = 0; row < tangent.size(); ++row)
        sum += tangent[row] * trace.displacement[row][sample];
    return sum;
}

// position of the surface at the first contact, of a constant drive or one with a frequency
double surface_position(const Case& c, double time) {
    const parameters::VelocityProfile profile = parameters::velocity_profile(c.drive);
    const double share = parameters::drive_share_at(c, 0);
    if (c.drive.kind == parameters::DriveKind::constant) return share * profile.velocity * time;
    return share * profile.amplitude * base::sine_cosine_of_turns(profile.frequency * time).sine;
}

double number_in(std::string_view text) {
    return std::strtod(std::string(text).c_str(), nullptr);
}

record::Trace sample_at(const Case& c, double time) {
    record::Request request;
    request.trace = {.from = time, .to = time, .interval = time};
    return motion_of(c, request).record.trace;
}

struct MeanCycle {
    double period = 0.0;  // [s] from release to release
    double slip = 0.0;    // [s] of it
};

// of all cycles from the first release on
MeanCycle mean_cycle(const Case& c) {
    const integration::Motion motion = motion_of(c, {record::KeepHistory::yes, {}});
    double first = 0.0, last = 0.0, slip = 0.0, slipped = 0.0;
    long releases = 0;
    for (const record::ContactInterval& stay : motion.record.histories.front()) {
        if (stay.state == model::ContactState::slip && stay.from > 0.0) {
            if (releases == 0) first = stay.from;
            last = stay.from;
            slipped = slip;
            ++releases;
        }
        if (stay.state == model::ContactState::slip && releases > 0) slip += stay.to - stay.from;
    }
    if (releases < 2) base::refuse("the contact is released " + std::to_string(releases) + " times", "", "");
    const auto cycles = static_cast<double>(releases - 1);
    return {(last - first) / cycles, slipped / cycles};
}

const record::Tally& phase_called(const integration::Motion& motion, std::string_view name) {
    for (const record::Tally& tally : motion.record.phases)
        if (name.empty() || record::phase_names[static_cast<std::size_t>(tally.phase)] == name) return tally;
    base::refuse("the run has no phase " + std::string(name), "", "");
}

analysis::StabilityBoundary stable_boundary(const Case& c, std::string_view about) {
    for (const analysis::DirectionScan& scan :
         analysis::scan_stability(c, io::read_scan_range(std::string(about))).directions)
        for (const analysis::StabilityBoundary& boundary : scan.path.boundaries)
            if (boundary.below == analysis::StabilityKind::stable || boundary.above == analysis::StabilityKind::stable)
                return boundary;
    base::refuse("steady sliding is not stable on one side of a limit along " + std::string(about), "", "");
}

using Property = bool (*)(const Case&);

bool sticks_on(const Case& c) {
    return analysis::evidence(motion_of(c).record.phases.front(), 0).rates.stick > 0.0;
}

bool has_helmholtz_motion(const Case& c) {
    const classification::Verdict verdict =
        classification::classify_phase(motion_of(c).record.phases.front(), c.verdict);
    const double pitch = *parameters::recipe_number(c, "frequency");  // [Hz]
    return verdict.category == classification::Category::squeal &&
           std::abs(verdict.evidence.alternation.frequency / pitch - 1.0) < 0.02 &&
           verdict.evidence.judged_rates.slip < 2.0 * *parameters::recipe_number(c, "position");
}

// bisected until the ends are nearer than `share` of the value; the lower end has the property, or only the upper one
double limit_of(const Case& c, std::string_view about, Property has, double share) {
    const analysis::ScanRange range = io::read_scan_range(std::string(about));
    const auto at = [&](double value) {
        Case changed = c;
        parameters::set_quantity(changed, range.key, value);
        return has(changed);
    };
    double from = range.from, to = range.to;
    const bool below = at(from);
    if (below == at(to))
        base::refuse("no limit lies in " + std::string(about), "both ends are of one kind", "Take a wider range.");
    while (to - from > share * to) {
        const double middle = 0.5 * (from + to);
        (at(middle) == below ? from : to) = middle;
    }
    return 0.5 * (from + to);
}

constexpr double fine_share = 1e-7;       // of limits that cost milliseconds a run
constexpr double coarse_share = 0.004;    // of those that cost a tenth of a second
constexpr double fine_samples = 50000.0;  // of a window: of one period the peak is known to 2e-9 of itself

}  // namespace

double slip_amplitude(const Case& c, std::string_view) {
    const record::Trace trace = motion_of(c, over_window(c, c.run.window / fine_samples)).record.trace;
    double least = 0.0, most = 0.0;
    for (std::size_t k = 0; k < trace.time.size(); ++k) {
        const double slip = position(c, trace, k) - surface_position(c, trace.time[k]);
        least = k == 0 ? slip : std::min(least, slip);
        most = k == 0 ? slip : std::max(most, slip);
    }
    return 0.5 * (most - least);
}

double position_at(const Case& c, std::string_view about) {
    return position(c, sample_at(c, number_in(about)), 0);
}

double slip_at(const Case& c, std::string_view about) {
    return position_at(c, about) - surface_position(c, number_in(about));
}

double slip_velocity_at(const Case& c, std::string_view about) {
    const record::Trace trace = sample_at(c, number_in(about));
    const std::vector<double> tangent = parameters::point_weights(c, 0, parameters::PointAxis::sliding);
    double sum = -parameters::drive_share_at(c, 0) * trace.surface_velocity.at(0);
    for (std::size_t row = 0; row < tangent.size(); ++row)
        sum += tangent[row] * trace.velocity[row].at(0);
    return sum;
}

double greatest_friction(const Case& c, std::string_view) {
    const record::Trace trace = motion_of(c, over_window(c, c.run.window / fine_samples)).record.trace;
    double most = 0.0;
    for (const double force : trace.contacts.front().friction_force)
        most = std::max(most, std::abs(force));
    return most;
}

double greatest_slip_velocity(const Case& c, std::string_view) {
    const record::Trace trace = motion_of(c, over_window(c, c.run.window / fine_samples)).record.trace;
    const std::vector<double> tangent = parameters::point_weights(c, 0, parameters::PointAxis::sliding);
    double most = 0.0;
    for (std::size_t k = 0; k < trace.time.size(); ++k) {
        double sum = -trace.surface_velocity[k];
        for (std::size_t row = 0; row < tangent.size(); ++row)
            sum += tangent[row] * trace.velocity[row][k];
        most = std::max(most, std::abs(sum));
    }
    return most;
}

double release_period(const Case& c, std::string_view) {
    return mean_cycle(c).period;
}

double slip_time(const Case& c, std::string_view) {
    return mean_cycle(c).slip;
}

double stick_share(const Case& c, std::string_view) {
    const MeanCycle cycle = mean_cycle(c);
    return 1.0 - cycle.slip / cycle.period;
}

double wear_power(const Case& c, std::string_view) {
    Case before = c;
    before.run.duration = before.run.window = c.run.duration - c.run.window;
    const double loss = motion_of(c).energy.friction_loss - motion_of(before).energy.friction_loss;
    return loss / (c.contact().kinetic_friction * c.run.window);
}

double output_rms(const Case& c, std::string_view) {
    record::Trace trace = motion_of(c, over_window(c, c.run.step)).record.trace;
    record::add_points(trace, parameters::output_weights(c));
    double sum = 0.0;
    for (const double velocity : trace.velocity.at(parameters::coordinate_count(c)))
        sum += velocity * velocity;
    return std::sqrt(sum / static_cast<double>(trace.time.size()));
}

double category(const Case& c, std::string_view about) {
    const integration::Motion motion = motion_of(c);
    return static_cast<double>(classification::classify_phase(phase_called(motion, about), c.verdict).category);
}

double slip_share(const Case& c, std::string_view about) {
    const integration::Motion motion = motion_of(c);
    return analysis::evidence(phase_called(motion, about), 0).judged_rates.slip;
}

double stability_limit(const Case& c, std::string_view about) {
    return stable_boundary(c, about).value;
}

double motion_under_steady_drive(const Case& c, std::string_view) {
    const analysis::DirectionScan going = analysis::scan_stability(c, std::nullopt).directions.front();
    return going.here.kind == analysis::StabilityKind::stable ? 0.0 : 1.0;
}

double stability_frequency(const Case& c, std::string_view about) {
    return stable_boundary(c, about).frequency;
}

double stick_limit(const Case& c, std::string_view about) {
    return limit_of(c, about, sticks_on, fine_share);
}

double greatest_helmholtz_force(const Case& c, std::string_view about) {
    return limit_of(c, about, has_helmholtz_motion, coarse_share);
}

}  // namespace stridor::verification
