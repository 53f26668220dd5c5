#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/record/contact_history.hpp"
#include "stridor/record/trace.hpp"

#include <string>
#include <vector>

/// Motions as CSV text, in the form of all our tables (base/csv_text.hpp). Nothing in it changes between two runs of
/// the same case.
namespace stridor::io {

/// "stridor.trace/1": a row per sample, the columns of record/columns.hpp and the state of each contact. `interval` [s]
/// is the one that was asked for; a trace of one sample has no other.
std::string trace_csv(const parameters::Case& c, const record::Trace& trace, double interval);

/// "stridor.history/1": a row per stay of a contact in one state; with several contacts the number of the contact, from
/// 1, stands first.
std::string history_csv(const parameters::Case& c, const std::vector<record::ContactHistory>& histories);

}  // namespace stridor::io
