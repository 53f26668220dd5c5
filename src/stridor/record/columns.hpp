#pragma once

#include "stridor/record/trace.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The one list of a trace's columns: tables, netCDF, the page and figures take names, units and sentences from here.
namespace stridor::record {

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

/// What is put behind the name of a column of contact `index` of `contacts`: nothing for the only one, else "_1", "_2".
std::string contact_ending(std::size_t index, std::size_t contacts);

/// A column of numbers of a trace as it stands in a table.
struct NumberColumn {
    std::string name;
    std::string_view unit;
    const std::vector<double>* samples = nullptr;
};

/// All columns of numbers, in the order of tables: time, those of the degrees of freedom by these names, the surface's,
/// those of each contact. They point into the trace.
std::vector<NumberColumn> columns(const Trace& trace, std::span<const std::string> dofs);

}  // namespace stridor::record
