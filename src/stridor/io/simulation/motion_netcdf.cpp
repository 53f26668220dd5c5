#include "stridor/io/simulation/motion_netcdf.hpp"

#include "stridor/base/hash.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/netcdf_dataset.hpp"
#include "stridor/io/simulation/dof_names.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace stridor::io {

namespace {

void put_trace(NetcdfDataset& file, const record::Trace& trace) {
    const std::vector<std::string> names = dof_names(trace.displacement.size());
    const int time = file.dimension("time", trace.time.size());
    const int dof = file.dimension("dof", names.size());
    file.doubles("time", std::array{time}, trace.time, {"s", "time", Missing::no});
    file.words("dof", std::array{dof}, names, {"", "degree of freedom"});

    const auto put_motion = [&](const std::string& name, const std::vector<std::vector<double>>& motion,
                                const Description& description) {
        std::vector<double> values;
        for (const std::vector<double>& row : motion)
            values.insert(values.end(), row.begin(), row.end());
        file.doubles(name, std::array{dof, time}, values, description);
    };
    put_motion("displacement", trace.displacement, {"m", "displacement from the preloaded rest position"});
    put_motion("velocity", trace.velocity, {"m/s", "velocity"});
    put_motion("acceleration", trace.acceleration, {"m/s^2", "acceleration"});

    const std::array along{time};
    file.doubles("surface_velocity", along, trace.surface_velocity, {"m/s", "imposed velocity of the plate"});
    file.doubles("normal_force", along, trace.normal_force, {"N", "normal contact force on the joint"});
    file.doubles("friction_force", along, trace.friction_force, {"N", "friction force on the joint"});
    file.doubles("gap", along, trace.gap, {"m", "gap between joint and plate"});
    std::vector<signed char> states;
    for (const model::ContactState state : trace.state)
        states.push_back(static_cast<signed char>(state));
    file.flags("state", along, states, model::contact_state_names, {"", "contact state"});
}

void put_history(NetcdfDataset& file, const record::ContactHistory& history) {
    const std::array along{file.dimension("interval", history.size())};
    std::vector<signed char> states;
    for (const record::ContactInterval& interval : history)
        states.push_back(static_cast<signed char>(interval.state));
    file.flags("interval_state", along, states, model::contact_state_names, {"", "contact state"});
    const auto put = [&](const std::string& name, double record::ContactInterval::*member,
                         const Description& description) {
        std::vector<double> values;
        for (const record::ContactInterval& interval : history)
            values.push_back(interval.*member);
        file.doubles(name, along, values, description);
    };
    put("interval_from", &record::ContactInterval::from, {"s", "time at which the state began", Missing::no});
    put("interval_to", &record::ContactInterval::to, {"s", "time at which it ended", Missing::no});
    put("interval_slip_velocity", &record::ContactInterval::slip_velocity, {"m/s", "slip velocity at its beginning"});
    put("interval_gap_velocity", &record::ContactInterval::gap_velocity,
        {"m/s", "velocity of the gap at its beginning; negative: the surfaces met"});
}

}  // namespace

void write_trace_netcdf(const std::string& path, const parameters::Case& c, const record::Record& record) {
    const std::string canonical = parameters::canonical_text(c);
    NetcdfDataset file(path);
    put_origin(file, "trace", c.title.empty() ? "simulated motion" : c.title);
    file.attribute("study", canonical);
    file.attribute("study_hash", base::hash_text(canonical));
    file.attribute("case", case_toml(c, {.comments = Comments::none, .heading = ""}));
    if (!record.trace.time.empty()) put_trace(file, record.trace);
    if (!record.history.empty()) put_history(file, record.history);
    file.finish([&](std::string_view bytes) { storage::write_file(path, bytes); });
}

}  // namespace stridor::io
