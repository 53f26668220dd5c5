#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/record/recorder.hpp"

#include <string>

namespace stridor::io {

/// A trace and the contact histories of a run, as far as they were kept: dimensions time, dof and interval;
/// displacement, velocity and acceleration as (dof, time), forces, gap and contact state as (time), or (contact, time)
/// if there are several contacts, the histories' stays as interval_*(interval). The kind of file is that of charts
/// (io/chart/chart_netcdf.hpp). Throws `Error` (io).
void write_trace_netcdf(const std::string& path, const parameters::Case& c, const record::Record& record);

}  // namespace stridor::io
