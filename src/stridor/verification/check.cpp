#include "stridor/verification/check.hpp"

#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/integration/exact/exact.hpp"
#include "stridor/verification/single_mass.hpp"
#include "stridor/verification/table_1.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace stridor::verification {

bool Check::passes() const {
    return std::abs(computed - expected) <= tolerance;
}

parameters::Drive constant_drive(double velocity) {
    parameters::Drive drive;
    drive.kind = parameters::DriveKind::constant;
    drive.velocity = velocity;
    return drive;
}

record::Recorder whole_run(double from, double to, const record::TraceRequest& trace) {
    record::Schedule schedule;
    if (from > 0.0) schedule.spans.push_back({0.0, from, record::Phase::all, record::Use::unused});
    schedule.spans.push_back({from, to, record::Phase::all, record::Use::judged});
    schedule.phases = {record::Phase::all};
    return {schedule, {record::KeepHistory::no, trace}, 2};
}

integration::Motion run_belt(const model::Belt& belt, const parameters::Drive& drive, parameters::Engine engine,
                             record::Recorder recorder) {
    const auto structure = model::mass_on_belt(belt);
    const bool sticks = parameters::is_steady(drive);
    const integration::Start start{sticks ? parameters::Initial::stuck : parameters::Initial::rest, 0.0};
    if (engine == parameters::Engine::exact)
        return integration::integrate_exact(structure, drive, start, {}, std::move(recorder));
    return integration::integrate_beta_2(structure, drive, start, {1e-6, 0.5}, std::move(recorder));
}

std::span<const CheckGroup> check_groups() {
    static constexpr std::array groups{
        CheckGroup{"natural frequencies", "Table 1 parameters, undamped eigenvalues, closed form",
                   natural_frequency_checks},
        CheckGroup{"stability of steady sliding", "4 by 4 eigenvalue problem solved independently", stability_checks},
        CheckGroup{"observed order of beta_2", "damped oscillator in pure slip, closed form", order_checks},
        CheckGroup{"mass on a belt", "stick time 2 lambda / w0, slip time 2 (pi - atan lambda) / w0", belt_checks},
        CheckGroup{"dry-friction oscillator", "Den Hartog 1931, continuous sliding", den_hartog_checks},
        CheckGroup{"Table 1, sinusoidal drive", "stored digits of the exact engine; beta_2 within its own error",
                   table_1_checks},
        CheckGroup{"constant drive", "exact piecewise linear solution", constant_drive_checks},
    };
    return groups;
}

}  // namespace stridor::verification
