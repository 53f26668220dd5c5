#pragma once

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/record/recorder.hpp"
#include "stridor/record/tally.hpp"
#include "stridor/record/trace.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::io {

/// What moves in the degrees of freedom of the rubbing system, after "displacement".
inline constexpr std::array<std::string_view, 3> dof_sentences{
    "of the joint along the plate", "of the joint across the plate", "of the plate across the contact"};

/// Names of the degrees of freedom in files: x1, y1, y2 of the rubbing system; of several joints x and y with their
/// names, then y_plate; of an own structure its rows.
inline std::vector<std::string> dof_names(const parameters::Case& c) {
    if (c.own_structure) return c.own_structure->row;
    if (c.further_joints.empty()) return {"x1", "y1", "y2"};
    std::vector<std::string> names;
    for (std::size_t k = 0; k < parameters::joint_count(c); ++k)
        for (const std::string_view direction : {"x_", "y_"})
            names.push_back(std::string(direction) + parameters::joint_name(c, k));
    names.emplace_back("y_plate");
    return names;
}

/// The same, with the outputs of an own structure where they are in the record, or u1, u2, ... where it is of another
/// structure.
inline std::vector<std::string> dof_names(const parameters::Case& c, std::size_t count) {
    std::vector<std::string> names = dof_names(c);
    if (names.size() == count) return names;
    if (c.own_structure && names.size() + c.own_structure->outputs.size() == count) {
        for (const parameters::OwnOutput& output : c.own_structure->outputs)
            names.push_back(output.name);
        return names;
    }
    names.clear();
    for (std::size_t k = 1; k <= count; ++k)
        names.push_back("u" + std::to_string(k));
    return names;
}

// Motions as CSV text, in the form of all our tables (base/csv_text.hpp). Nothing in it changes between two runs of
// the same case.

/// "stridor.trace/1": a row per sample, the columns of record/trace.hpp and the state of each contact. `interval` [s]
/// is the one that was asked for; a trace of one sample has no other.
std::string trace_csv(const parameters::Case& c, const record::Trace& trace, double interval);

/// "stridor.history/1": a row per stay of a contact in one state; with several contacts the number of the contact, from
/// 1, stands first.
std::string history_csv(const parameters::Case& c, const std::vector<record::ContactHistory>& histories);

/// A trace and the contact histories of a run, as far as they were kept: dimensions time, dof and interval;
/// displacement, velocity and acceleration as (dof, time), forces, gap and contact state as (time), or (contact, time)
/// if there are several contacts, the histories' stays as interval_*(interval). The kind of file is that of charts
/// (io/chart/chart_netcdf.hpp). Throws `Error` (io).
void write_trace_netcdf(const std::string& path, const parameters::Case& c, const record::Record& record);

/// Writes "stridor.modes/1", a row per mode of steady sliding: direction, the value of the parameter where one was
/// followed, what sliding is there, frequency, growth, damping ratio, and whether the mode grows. Where sliding locks
/// or leaves no motion a row says so without a mode.
std::string stability_csv(const analysis::StabilityScan& scan);

}  // namespace stridor::io
