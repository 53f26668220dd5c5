#include "stridor/verification/runs.hpp"

#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/integration/exact/exact.hpp"

#include <utility>

namespace stridor::verification {

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

}  // namespace stridor::verification
