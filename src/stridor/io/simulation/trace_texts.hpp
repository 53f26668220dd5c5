#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/record/trace.hpp"

#include <string>

namespace stridor::io {

/// Which samples of a motion are wanted, as a command line says it: times with their units.
struct TraceTexts {
    std::string from{};  // empty: the beginning
    std::string to{};    // empty: the end
    std::string interval = "20 us";
};

/// The samples that the texts ask for. Throws `Error` (input) for what is no time, for a trace without samples, and for
/// more than two million of them: a trace is kept in memory.
record::TraceRequest trace_request(const TraceTexts& texts, const parameters::Case& c);

}  // namespace stridor::io
