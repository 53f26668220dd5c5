#pragma once

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/io/netcdf_dataset.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/record/recorder.hpp"
#include "stridor/record/tally.hpp"
#include "stridor/record/trace.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::io {

/// Returns names of `count` degrees of freedom: with the outputs of an own structure if they are in the record, and u1,
/// u2, ... if it is that of another structure.
inline std::vector<std::string> dof_names(const parameters::Case& c, std::size_t count) {
    std::vector<std::string> names = parameters::coordinate_names(c);
    if (names.size() == count) return names;
    for (const parameters::OwnOutput& output : parameters::outputs_of(c))
        names.push_back(output.name);
    if (names.size() == count) return names;
    names.clear();
    for (std::size_t k = 1; k <= count; ++k)
        names.push_back("u" + std::to_string(k));
    return names;
}

/// A number of each stay of a contact in one state, as all tables of them have it.
struct IntervalColumn {
    std::string_view name;
    std::string_view unit;
    std::string_view sentence;
    double record::ContactInterval::*member;
};

inline constexpr std::array<IntervalColumn, 4> interval_columns{
    {{"from", "s", "time at which the state began", &record::ContactInterval::from},
     {"to", "s", "time at which it ended", &record::ContactInterval::to},
     {"slip_velocity", "m/s", "slip velocity at its beginning", &record::ContactInterval::slip_velocity},
     {"gap_velocity", "m/s", "velocity of the gap at its beginning; negative: the surfaces met",
      &record::ContactInterval::gap_velocity}}};

/// Says where a table of runs of a case came from: title, program with version and commit, the schema
/// "stridor.SCHEMA/1", and the case with its engine, as canonical text (`study`, with its hash) and as TOML (`case`).
Attributes origin_of_run(std::string_view schema, const parameters::Case& c);

/// The numbers of one column of a trace.
struct TraceArray {
    std::string_view name;
    std::string_view unit;
    std::string_view sentence;
    std::string_view outer;      // "dof" or "contact", where there is a row of samples for each; else empty
    std::vector<double> values;  // shape [outer][sample]
};

/// Shows all columns of numbers of a trace, in the order of files. Those of contacts have rows where there are several.
void visit_arrays(const record::Trace& trace, const std::function<void(TraceArray&)>& use);

/// Returns the states of the contacts as numbers of `model::contact_state_names`; shape [contact][sample].
std::vector<signed char> states_of(const record::Trace& trace);

// Motions as CSV text, in the form of all our tables (base/csv_text.hpp). Nothing in it changes between two runs of
// the same case.

/// Returns "stridor.trace/1": a row per sample, the columns of record/trace.hpp and the state of each contact.
/// `interval` [s] is the one that was asked for; a trace of one sample has no other.
std::string trace_csv(const parameters::Case& c, const record::Trace& trace, double interval);

/// Returns "stridor.history/1": a row per stay of a contact in one state; with several contacts the number of the
/// contact, from 1, stands first.
std::string history_csv(const parameters::Case& c, const std::vector<record::ContactHistory>& histories);

/// Writes a trace and the contact histories of a run, as far as they were kept: dimensions time, dof and interval;
/// displacement, velocity and acceleration as (dof, time), forces, gap and contact state as (time), or (contact, time)
/// if there are several contacts, the histories' stays as interval_*(interval). The kind of file is that of charts
/// (io/chart/chart_netcdf.hpp). Throws `Error` (io).
void write_trace_netcdf(const std::string& path, const parameters::Case& c, const record::Record& record);

/// Writes "stridor.modes/1", a row per mode of steady sliding: direction, the value of the parameter where one was
/// followed, what sliding is there, frequency, growth, damping ratio, and whether the mode grows. Where sliding locks
/// or leaves no motion a row says so without a mode.
std::string stability_csv(const analysis::StabilityScan& scan);

}  // namespace stridor::io
