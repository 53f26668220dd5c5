#pragma once

#include "stridor/model/contact_state.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::record {

/// Sampled motion of one contact, all vectors of shape [sample].
struct ContactTrace {
    std::vector<double> normal_force;    // [N] N on the structure
    std::vector<double> friction_force;  // [N] T on the structure
    std::vector<double> gap;             // [m] g
    std::vector<model::ContactState> state;

    bool operator==(const ContactTrace&) const = default;
};

/// Sampled motion, all vectors of shape [sample], those per degree of freedom of shape [dof][sample].
struct Trace {
    std::vector<double> time;                       // [s]
    std::vector<std::vector<double>> displacement;  // [m] u
    std::vector<std::vector<double>> velocity;      // [m/s] u'
    std::vector<std::vector<double>> acceleration;  // [m/s^2] u''
    std::vector<double> surface_velocity;           // [m/s] V
    std::vector<ContactTrace> contacts;             // shape [contact]
};

/// One instant of a contact.
struct ContactSample {
    double normal_force = 0.0;    // [N]
    double friction_force = 0.0;  // [N]
    double gap = 0.0;             // [m]
    model::ContactState state = model::ContactState::slip;
};

/// One instant of a motion.
struct Sample {
    double time = 0.0;                     // [s]
    std::span<const double> displacement;  // [m] shape [dof]
    std::span<const double> velocity;      // [m/s] shape [dof]
    std::span<const double> acceleration;  // [m/s^2] shape [dof]
    double surface_velocity = 0.0;         // [m/s] V
    std::span<const ContactSample> contacts;
};

/// Returns a trace without samples for these numbers of degrees of freedom and contacts.
Trace empty_trace(int dofs, int contacts = 1);

/// Adds an instant at the end. It must have as many degrees of freedom and contacts as the trace.
void append(Trace& trace, const Sample& sample);

/// Appends the motion of points to that of the degrees of freedom: weights.u for each, shape [point][dof].
void add_points(Trace& trace, const std::vector<std::vector<double>>& weights);

/// Removes the samples; the memory stays.
void clear(Trace& trace);

/// The largest number of samples that a taker receives at a time.
inline constexpr std::size_t trace_block = 4096;

/// When to sample a trace. Engines sample at their own steps nearest to the asked ones.
struct TraceRequest {
    double from = 0.0;      // [s]
    double to = 0.0;        // [s]
    double interval = 0.0;  // [s] between samples; 0: no trace
    // receives the trace in blocks, in order, while the run goes on; the record then keeps no part of it
    std::function<void(const Trace&)> taker{};
};

// The one list of a trace's columns: tables, netCDF, the page and figures take names, units and sentences from here.

/// A column that a trace has once.
struct TraceColumn {
    std::string_view name;
    std::string_view unit;
    std::string_view sentence;
    std::vector<double> Trace::*samples;
};

/// A column for each degree of freedom: "velocity_x1".
struct DofColumn {
    std::string_view name;
    std::string_view unit;
    std::string_view sentence;
    std::vector<std::vector<double>> Trace::*samples;
};

/// A column for each contact: "gap"; with several of them "gap_1", "gap_2".
struct ContactColumn {
    std::string_view name;
    std::string_view unit;
    std::string_view sentence;
    std::vector<double> ContactTrace::*samples;
};

inline constexpr TraceColumn time_column{"time", "s", "time", &Trace::time};
inline constexpr std::array<DofColumn, 3> dof_columns{
    {{"displacement", "m", "displacement from the preloaded rest position", &Trace::displacement},
     {"velocity", "m/s", "velocity", &Trace::velocity},
     {"acceleration", "m/s^2", "acceleration", &Trace::acceleration}}};
inline constexpr TraceColumn surface_column{"surface_velocity", "m/s", "imposed velocity of the plate",
                                            &Trace::surface_velocity};
inline constexpr std::array<ContactColumn, 3> contact_columns{
    {{"normal_force", "N", "normal contact force on the joint", &ContactTrace::normal_force},
     {"friction_force", "N", "friction force on the joint", &ContactTrace::friction_force},
     {"gap", "m", "gap between joint and plate", &ContactTrace::gap}}};
/// Contact states are words, and have a column of their own for each contact.
inline constexpr std::string_view state_column = "state";

/// Returns the ending of a column's name for contact `index` of `contacts`: empty for the only one, else "_1", "_2".
std::string contact_ending(std::size_t index, std::size_t contacts);

/// A column of numbers of a trace as it stands in a table.
struct NumberColumn {
    std::string name;
    std::string_view unit;
    const std::vector<double>* samples = nullptr;
};

/// Returns all columns of numbers, in the order of tables: time, those of the degrees of freedom by these names, the
/// surface's, those of each contact. They point into the trace.
std::vector<NumberColumn> columns(const Trace& trace, std::span<const std::string> dofs);

}  // namespace stridor::record
