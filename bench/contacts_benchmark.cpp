// Speed with several contacts: two joints on a plate, strips of rubber, a bowed string. Processor time per simulated
// second, changes of contact states, the share of sticking.

#include "stridor/integration/series/taylor.hpp"
#include "stridor/integration/steps/moreau.hpp"
#include "stridor/model/built/bowed_string.hpp"
#include "stridor/model/built/joints_on_plate.hpp"
#include "stridor/record/schedule.hpp"
#include "support/structures/meshed_strip.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <utility>

namespace stridor {
namespace {

// of all contacts together, in the window
double stick_share(const integration::Motion& motion) {
    double stick = 0.0, all = 0.0;
    for (const record::ContactTally& contact : motion.record.phases.front().contacts) {
        stick += contact.time[model::index_of(model::ContactState::stick)];
        all += contact.time[0] + contact.time[1] + contact.time[2];
    }
    return stick / all;
}

// by events, or by steps where `step` is above zero
void run_contacts(benchmark::State& state, const support::RubberStrip& given, double duration, double step = 0.0) {
    parameters::Case c;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = given.velocity;
    c.run.duration = duration;
    c.run.window = 0.75 * duration;
    long changes = 0;
    double stick = 0.0;
    for ([[maybe_unused]] const auto run : state) {
        record::Recorder recorder(record::schedule(c), {record::KeepHistory::yes, {}}, model::dofs_of(given.structure),
                                  static_cast<int>(given.structure.contacts.size()));
        const integration::Motion motion =
            step > 0.0
                ? integration::integrate_moreau(given.structure, c.drive, given.start, {step}, std::move(recorder))
                : integration::integrate_taylor(given.structure, c.drive, given.start, {parameters::EarlyEnding::never},
                                                std::move(recorder));
        if (motion.outcome.reason != integration::Reason::completed) return state.SkipWithError("did not complete");
        stick = stick_share(motion);
        changes = 0;
        for (const record::ContactHistory& history : motion.record.histories)
            changes += static_cast<long>(history.size());
    }
    state.counters["s_per_s"] = benchmark::Counter(duration * static_cast<double>(state.iterations()),
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["changes_per_s"] = static_cast<double>(changes) / duration;
    state.counters["stick"] = stick;
}

support::RubberStrip two_joints(double preload, double kinetic_friction, double velocity, double angle) {
    std::array<model::PlateJoint, 2> joints;
    joints[1].joint.incidence_angle = angle;
    for (model::PlateJoint& joint : joints) {
        joint.contact.preload = preload;
        joint.contact.kinetic_friction = kinetic_friction;
    }
    support::RubberStrip given{model::joints_on_plate(joints, {}), {}, velocity};
    given.start = integration::initial_state(given.structure, {parameters::Initial::stuck, 0.0}, velocity);
    return given;
}

// two slips of each joint in a period of 5.238 ms
void taylor_two_joints(benchmark::State& state) {
    run_contacts(state, two_joints(200.0, 0.2, -0.1, 60.0), 2.0);
}
BENCHMARK(taylor_two_joints)->Unit(benchmark::kMillisecond);

// the same with pile-ups of impacts
void taylor_pile_ups(benchmark::State& state) {
    run_contacts(state, two_joints(100.0, 0.3, 0.1, 40.0), 2.0);
}
BENCHMARK(taylor_pile_ups)->Unit(benchmark::kMillisecond);

// elements along the strip: n = 8 (columns + 1) modes, columns + 1 contacts
void taylor_strip(benchmark::State& state) {
    const auto columns = static_cast<int>(state.range(0));
    run_contacts(state, support::meshed_strip(columns, support::MeshMass::lumped), 0.8 / columns);
}
BENCHMARK(taylor_strip)->ArgName("columns")->Arg(1)->Arg(4)->Arg(9)->Arg(19)->Unit(benchmark::kMillisecond);

// mu_s = mu_d, as a peer that knows one coefficient takes it (peers/siconos_strip.py): event by event, by steps [us]
void one_coefficient(benchmark::State& state) {
    support::RubberStrip strip = support::meshed_strip(static_cast<int>(state.range(0)), support::MeshMass::lumped);
    for (model::ContactPoint& contact : strip.structure.contacts)
        contact.friction = model::Coulomb{0.5, 0.5};
    run_contacts(state, strip, 0.4, 1e-6 * static_cast<double>(state.range(1)));
}
BENCHMARK(one_coefficient)
    ->ArgNames({"columns", "step_us"})
    ->ArgsProduct({{4, 9}, {0, 1, 4, 10}})
    ->Unit(benchmark::kMillisecond);

void taylor_string(benchmark::State& state) {
    const auto modes = static_cast<int>(state.range(0));
    const model::BowedString string;
    support::RubberStrip given{model::bowed_string(string, modes), {Eigen::VectorXd::Zero(modes + 1), {}}, 0.1};
    given.start.velocity = model::helmholtz_motion(string, modes, given.velocity);
    run_contacts(state, given, 0.2);
}
BENCHMARK(taylor_string)->ArgName("modes")->Arg(20)->Arg(40)->Arg(80)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stridor
