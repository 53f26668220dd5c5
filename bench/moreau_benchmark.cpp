// Speed of Moreau's time stepping: time per step against the number of modes and of contacts, on a strip of rubber made
// of springs with lumped masses, and on two joints on a plate.

#include "stridor/integration/steps/moreau.hpp"
#include "stridor/model/built/joints_on_plate.hpp"
#include "stridor/record/schedule.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <utility>

namespace stridor {
namespace {

constexpr double step = 1e-6;      // [s]
constexpr double velocity = 0.1;   // [m/s]
constexpr double duration = 2e-2;  // [s]

// `columns` by `rows` masses, linked to their neighbours and across; the lowest row rubs, the highest is held
model::Structure lattice_strip(int columns, int rows) {
    constexpr double mass = 1e-5;       // [kg]
    constexpr double stiffness = 2e4;   // [N/m] of a link
    constexpr double preload = 0.05;    // [N] on each contact
    constexpr double decay = 20.0;      // [1/s] damping over mass
    constexpr double smoothing = 1e-7;  // [s] damping over stiffness
    const int dofs = 2 * columns * rows;
    model::Structure structure = model::structure_of_size(dofs, columns);
    const auto link = [&](std::array<int, 2> from, std::array<int, 2> to) {
        if (to[0] < 0 || to[0] >= columns) return;
        Eigen::Vector2d along(to[0] - from[0], to[1] - from[1]);
        along.normalize();
        const Eigen::Matrix2d k = stiffness * along * along.transpose();
        const int a = 2 * (from[0] + columns * from[1]);
        const int b = 2 * (to[0] + columns * to[1]);
        structure.stiffness.block<2, 2>(a, a) += k;
        if (to[1] >= rows) return;  // held
        structure.stiffness.block<2, 2>(b, b) += k;
        structure.stiffness.block<2, 2>(a, b) -= k;
        structure.stiffness.block<2, 2>(b, a) -= k;
    };
    for (int x = 0; x < columns; ++x)
        for (int y = 0; y < rows; ++y)
            for (const std::array<int, 2> way : {std::array{1, 0}, {0, 1}, {1, 1}, {-1, 1}})
                link({x, y}, {x + way[0], y + way[1]});
    structure.mass = mass * Eigen::MatrixXd::Identity(dofs, dofs);
    structure.damping = decay * structure.mass + smoothing * structure.stiffness;
    for (int x = 0; x < columns; ++x) {
        model::ContactPoint& contact = structure.contacts[static_cast<std::size_t>(x)];
        contact.tangent(2 * x) = contact.normal(2 * x + 1) = 1.0;
        structure.load(2 * x + 1) = -preload;
        contact.friction = model::Coulomb{0.8, 0.5};
    }
    return structure;
}

void run_steps(benchmark::State& state, const model::Structure& structure) {
    parameters::Case c;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = velocity;
    c.run.duration = c.run.window = duration;
    const integration::InitialState start =
        integration::initial_state(structure, {parameters::Initial::rest, 0.0}, velocity);
    long changes = 0;
    for ([[maybe_unused]] const auto run : state) {
        record::Recorder recorder(record::schedule(c), {record::KeepHistory::yes, {}}, model::dofs_of(structure),
                                  static_cast<int>(structure.contacts.size()));
        const integration::Motion motion =
            integration::integrate_moreau(structure, c.drive, start, {step}, std::move(recorder));
        if (motion.outcome.reason != integration::Reason::completed) return state.SkipWithError("did not complete");
        changes = 0;
        for (const record::ContactHistory& history : motion.record.histories)
            changes += static_cast<long>(history.size());
    }
    state.counters["us_per_step"] = benchmark::Counter(1e-6 * duration / step * static_cast<double>(state.iterations()),
                                                       benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["changes_per_step"] = static_cast<double>(changes) * step / duration;
}

// modes, contacts: with all that a run prepares, too
void moreau_strip(benchmark::State& state) {
    const auto contacts = static_cast<int>(state.range(1));
    const auto rows = static_cast<int>(state.range(0)) / (2 * contacts);
    run_steps(state, lattice_strip(contacts, rows));
}
BENCHMARK(moreau_strip)
    ->Args({40, 5})
    ->Args({80, 10})
    ->Args({160, 20})
    ->Args({600, 100})
    ->Unit(benchmark::kMillisecond);

void moreau_two_joints(benchmark::State& state) {
    std::array<model::PlateJoint, 2> joints;
    joints[1].joint.incidence_angle = 60.0;
    for (model::PlateJoint& joint : joints)
        joint.contact.preload = 200.0;
    run_steps(state, model::joints_on_plate(joints, {}));
}
BENCHMARK(moreau_two_joints)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stridor
