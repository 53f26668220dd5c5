#include "verify_checks.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/analysis/stability_path.hpp"
#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/integration/exact/exact.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/frequencies.hpp"
#include "stridor/model/mass_on_belt.hpp"
#include "stridor/model/rubbing_system.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace stridor::app {

namespace {

using model::ContactState;
using parameters::Case;
using parameters::Direction;
using parameters::DriveKind;
using parameters::PaperCase;

constexpr double two_pi = 2.0 * std::numbers::pi;

record::Recorder whole_run(double from, double to, record::TraceRequest trace = {}) {
    record::Schedule schedule;
    if (from > 0.0) schedule.spans.push_back({0.0, from, record::Phase::all, record::Use::unused});
    schedule.spans.push_back({from, to, record::Phase::all, record::Use::judged});
    schedule.phases = {record::Phase::all};
    return {schedule, {record::KeepHistory::no, trace}, 2};
}

parameters::Drive constant_drive(double velocity) {
    parameters::Drive drive;
    drive.kind = DriveKind::constant;
    drive.velocity = velocity;
    return drive;
}

// --- frequencies and stability ---------------------------------------------------------------------------------------

std::vector<Check> natural_frequency_checks() {
    const auto structure = model::rubbing_system(parameters::paper_case(PaperCase::squeal));
    std::vector<Check> checks;
    const auto add = [&](const char* name, ContactState state, std::size_t number, double expected) {
        checks.push_back(
            {name, expected, model::natural_frequencies(structure, state)[number] / two_pi, 1e-4 * expected});
    };
    add("slip, mu = 0, first [Hz]", ContactState::slip, 0, 429.17);
    add("slip, mu = 0, second [Hz]", ContactState::slip, 1, 916.36);
    add("stick [Hz]", ContactState::stick, 0, 709.88);
    add("open, plate [Hz]", ContactState::separation, 0, 251.65);
    add("open, joint flexural [Hz]", ContactState::separation, 1, 503.29);
    add("open, joint axial [Hz]", ContactState::separation, 2, 1591.55);
    return checks;
}

Case with_friction(Case c, double mu) {
    c.contact.kinetic_friction = mu;
    return c;
}

Case undamped(Case c) {
    c.joint.axial_damping = c.joint.flexural_damping = c.plate.damping = 0.0;
    return c;
}

analysis::StabilityPath over_friction(const Case& c, double to) {
    return analysis::stability_path(
        [&](double mu) {
            return analysis::sliding_stability(model::rubbing_system(with_friction(c, mu)), Direction::going);
        },
        0.0, to, 401);
}

std::vector<Check> stability_checks() {
    const Case c = parameters::paper_case(PaperCase::squeal);
    std::vector<Check> checks;
    checks.push_back({"flutter onset mu, damped", 0.44942, over_friction(c, 1.0).boundaries.at(0).value, 5e-4});
    const analysis::StabilityPath free = over_friction(undamped(c), 5.0);
    checks.push_back({"flutter onset mu, undamped", 0.48554, free.boundaries.at(0).value, 5e-4});
    checks.push_back({"its frequency [Hz]", 607.99, free.boundaries.at(0).frequency, 0.05});
    checks.push_back({"flutter gives way to divergence, mu, undamped", 2.576, free.boundaries.at(1).value, 5e-4});
    checks.push_back({"no sliding equilibrium from mu (sprag-slip)", 4.167, free.boundaries.at(2).value, 5e-4});
    const auto grown = analysis::sliding_stability(model::rubbing_system(with_friction(c, 0.6)), Direction::going);
    checks.push_back({"growth at mu = 0.6 [1/s]", 736.65, grown.growth, 0.01});
    checks.push_back({"its frequency [Hz]", 592.0, grown.frequency, 0.05});
    const std::array<std::pair<double, double>, 5> onsets{
        {{60, .641}, {65, .5385}, {75, .378}, {80, .337}, {85, .404}}};
    for (const auto& [angle, onset] : onsets) {
        Case tilted = c;
        tilted.joint.incidence_angle = angle;
        checks.push_back({fmt::format("flutter onset mu at {:g} deg", angle), onset,
                          over_friction(tilted, 1.0).boundaries.at(0).value, 5e-4});
    }
    return checks;
}

// --- closed forms ----------------------------------------------------------------------------------------------------

integration::Motion run_belt(const model::Belt& belt, const parameters::Drive& drive, parameters::Engine engine,
                             record::Recorder recorder) {
    const auto structure = model::mass_on_belt(belt);
    const bool sticks = drive.kind == DriveKind::constant;
    const integration::Start start{sticks ? parameters::Initial::stuck : parameters::Initial::rest, 0.0};
    if (engine == parameters::Engine::exact)
        return integration::integrate_exact(structure, drive, start, {}, std::move(recorder));
    return integration::integrate_beta_2(structure, drive, start, {1e-6, 0.5}, std::move(recorder));
}

// stick-slip on a belt: D = (mu_s - mu_d) F / k, lambda = w0 D / V; stick time 2 lambda / w0,
// slip time 2 (pi - atan lambda) / w0
double belt_stick_fraction(double lambda, parameters::Engine engine) {
    const double w0 = 100.0;  // [rad/s] about 1e5 steps of 1e-6 s a cycle
    const model::Belt belt{1.0, w0 * w0, 0.0, 10.0, {0.6, 0.2}};
    const double excess =
        (belt.friction.static_coefficient - belt.friction.kinetic_coefficient) * belt.preload / belt.stiffness;
    const double velocity = w0 * excess / lambda;
    const double cycle = (2.0 * lambda + 2.0 * (std::numbers::pi - std::atan(lambda))) / w0;
    const integration::Motion motion =
        run_belt(belt, constant_drive(velocity), engine, whole_run(2.0 * cycle, 10.0 * cycle));
    return analysis::rates(motion.record.phases.at(0).contacts.at(0).time).stick;
}

std::vector<Check> belt_checks() {
    std::vector<Check> checks;
    for (const double lambda : {0.5, 1.0, 2.0, 5.0}) {
        const double exact = lambda / (lambda + std::numbers::pi - std::atan(lambda));
        const std::string name = fmt::format("belt stick fraction, lambda = {:g}, ", lambda);
        checks.push_back({name + "exact", exact, belt_stick_fraction(lambda, parameters::Engine::exact), 1e-12});
        checks.push_back({name + "beta_2", exact, belt_stick_fraction(lambda, parameters::Engine::beta_2), 1e-3});
    }
    return checks;
}

// Den Hartog's x'' + x = cos(g t + phase) - r sign(x') is a mass on a shaken belt: with z = x1 - x2 and
// x2 = A sin(g t), z'' + z = (g^2 - 1) A sin(g t) + T / m, so A = 1 / (g^2 - 1) gives a unit force; z is
// what the formula speaks of.
double den_hartog_amplitude(double g, double r, parameters::Engine engine) {
    const double w0 = 100.0;  // [rad/s] time runs w0 times faster than in the formula
    const double amplitude = 1.0 / (g * g - 1.0);
    const model::Belt belt{1.0, w0 * w0, 0.0, w0 * w0 * 10.0, {r / 10.0, r / 10.0}};
    parameters::Drive drive;
    drive.kind = DriveKind::sinusoidal;
    drive.amplitude = amplitude;
    drive.frequency = g * w0 / two_pi;
    const double period = two_pi / (g * w0);
    const double end = 200.0 * period;
    const integration::Motion motion =
        run_belt(belt, drive, engine, whole_run(0.0, end, {end - 2.0 * period, end, 1e-6}));
    double largest = 0.0;
    const record::Trace& trace = motion.record.trace;
    for (std::size_t k = 0; k < trace.time.size(); ++k)
        largest = std::max(largest, std::abs(trace.displacement[0][k] - amplitude * std::sin(g * w0 * trace.time[k])));
    return largest;
}

std::vector<Check> den_hartog_checks() {
    struct Expected {
        double g, r, amplitude;
    };
    std::vector<Check> checks;
    for (const Expected& e : {Expected{1.5, 0.2, 0.765942}, Expected{1.5, 0.6, 0.4}, Expected{2.0, 0.4, 0.266667}}) {
        const std::string name = fmt::format("Den Hartog amplitude, g = {:g}, r = {:g}, ", e.g, e.r);
        checks.push_back(
            {name + "exact", e.amplitude, den_hartog_amplitude(e.g, e.r, parameters::Engine::exact), 1e-6});
        checks.push_back(
            {name + "beta_2", e.amplitude, den_hartog_amplitude(e.g, e.r, parameters::Engine::beta_2), 1e-3});
    }
    return checks;
}

// a damped oscillator in pure slip around mu N / k, against its closed form
double slip_error(double step, double beta_2) {
    const double w0 = 100.0, zeta = 0.05, velocity = 10.0, time = 0.1, kick = 1.0;
    const model::Belt belt{1.0, w0 * w0, 2.0 * zeta * w0, 10.0, {0.3, 0.3}};
    const integration::Motion motion = integration::integrate_beta_2(
        model::mass_on_belt(belt), constant_drive(velocity), {parameters::Initial::sliding, kick}, {step, beta_2},
        whole_run(0.0, time + step, {time, time, step}));
    const double wd = w0 * std::sqrt(1.0 - zeta * zeta);
    const double exact = belt.friction.kinetic_coefficient * belt.preload / belt.stiffness +
                         kick / wd * std::exp(-zeta * w0 * time) * std::sin(wd * time);
    return std::abs(motion.record.trace.displacement[0].at(0) - exact);
}

std::vector<Check> order_checks() {
    std::vector<Check> checks;
    for (const auto& [beta_2, order] : {std::pair{0.5, 2.0}, std::pair{0.8, 1.0}})
        for (const double step : {4e-4, 2e-4, 1e-4}) {
            const double observed = std::log2(slip_error(step, beta_2) / slip_error(0.5 * step, beta_2));
            checks.push_back({fmt::format("order at beta_2 = {:g}, h = {:g} to {:g} s", beta_2, step, 0.5 * step),
                              order, observed, 0.1});
        }
    return checks;
}

// --- the paper's cases -----------------------------------------------------------------------------------------------

struct ExpectedRates {
    PaperCase which;
    double beta_2_error;          // [1] measured at h = 1, 1/2, 1/4 and 1/8 us: the largest (table_1_test.cpp)
    std::array<double, 3> going;  // stick, slip, separation: the exact engine's digits
    std::array<double, 3> coming;
};

constexpr std::array<ExpectedRates, 4> table_1{{
    {PaperCase::quiet, .0150, {.0731810, .8807455, .0460735}, {.0502807, .9491487, .0005706}},
    {PaperCase::squeal, .0205, {.1726952, .1487222, .6785826}, {.0565966, .8492444, .0941591}},
    {PaperCase::squeak, .0151, {.4367432, .4280422, .1352146}, {.4358565, .5641435, .0}},
    {PaperCase::creak, .0071, {.8687976, .1294289, .0017736}, {.9227921, .0772079, .0}},
}};

void add_table_1_checks(std::vector<Check>& checks, const ExpectedRates& expected, parameters::Engine engine) {
    Case c = parameters::paper_case(expected.which);
    c.run.engine = engine;
    c.run.step = 1e-6;  // [s] beta_2
    const bool is_exact = engine == parameters::Engine::exact;
    const double tolerance = is_exact ? 1e-6 : 1.25 * expected.beta_2_error;
    for (const record::Tally& tally : integration::simulate(c).record.phases) {
        const analysis::Rates rates = analysis::rates(tally.contacts.at(0).time);
        const bool is_going = tally.phase == record::Phase::going;
        const std::array<double, 3>& values = is_going ? expected.going : expected.coming;
        const auto add = [&](const char* share, double value, double computed) {
            const std::string_view column = parameters::paper_case_names[static_cast<std::size_t>(expected.which)];
            checks.push_back({fmt::format("{} {} {}, {}", column, is_going ? "going" : "coming", share,
                                          is_exact ? "exact" : "beta_2"),
                              value, computed, tolerance});
        };
        add("stick", values[0], rates.stick);
        add("slip", values[1], rates.slip);
        add("separation", values[2], rates.separation);
    }
}

std::vector<Check> table_1_checks() {
    std::vector<Check> checks;
    for (const ExpectedRates& expected : table_1)
        for (const auto engine : {parameters::Engine::exact, parameters::Engine::beta_2})
            add_table_1_checks(checks, expected, engine);
    return checks;
}

// over the window from 1 to 2 s, its ends wherever they fall in a period
std::vector<Check> constant_drive_checks() {
    struct Expected {
        double preload, stick, period;
    };
    std::vector<Check> checks;
    for (const Expected& expected : {Expected{200.0, .247471, 1.0374406e-3}, Expected{1000.0, .749445, 2.4849233e-3},
                                     Expected{2000.0, .880442, 5.2618757e-3}}) {
        Case c = parameters::paper_case(PaperCase::squeak);
        c.contact.preload = expected.preload;
        c.drive = constant_drive(-0.1257);
        c.run.initial = parameters::Initial::stuck;
        c.run.duration = 2.0;
        const analysis::Evidence evidence = analysis::evidence(integration::simulate(c).record.phases.at(0), 0);
        checks.push_back({fmt::format("stick share, V = -0.1257, F = {:g} N", expected.preload), expected.stick,
                          evidence.rates.stick, 2e-6});
        checks.push_back({"its period [s]", expected.period, evidence.alternation.period, 1e-7 * expected.period});
    }
    return checks;
}

}  // namespace

bool Check::passes() const {
    return std::abs(computed - expected) <= tolerance;
}

const std::vector<CheckGroup>& check_groups() {
    static const std::vector<CheckGroup> groups{
        {"natural frequencies", "Table 1 parameters, undamped eigenvalues, closed form", natural_frequency_checks},
        {"stability of steady sliding", "4 by 4 eigenvalue problem solved independently", stability_checks},
        {"observed order of beta_2", "damped oscillator in pure slip, closed form", order_checks},
        {"mass on a belt", "stick time 2 lambda / w0, slip time 2 (pi - atan lambda) / w0", belt_checks},
        {"dry-friction oscillator", "Den Hartog 1931, continuous sliding", den_hartog_checks},
        {"Table 1, sinusoidal drive", "stored digits of the exact engine; beta_2 within its own error", table_1_checks},
        {"constant drive", "exact piecewise linear solution", constant_drive_checks},
    };
    return groups;
}

}  // namespace stridor::app
