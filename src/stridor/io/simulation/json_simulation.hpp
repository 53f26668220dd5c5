#pragma once

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/integration/cost.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/described_record.hpp"
#include "stridor/parameters/case.hpp"

#include <span>
#include <string>
#include <vector>

/// JSON documents: what `--json` prints, without a line end after the last brace. Each opens with its schema, the
/// program's version and commit, and holds the whole case and a table of units. Numbers read back as the same doubles;
/// NaN and infinities are null.
namespace stridor::io {

/// Returns a case alone, its sections as objects: {"title": ..., "joint": {"mass": 0.1, ...}, ...};
/// only keys that belong to it.
std::string case_json(const parameters::Case& c);

/// Returns "stridor.check/1": where it comes from, and the case itself, its sections at the top.
std::string check_json(const parameters::Case& c);

/// Returns "stridor.simulation/1": case, engine, outcome, energy balance and a verdict per phase.
///
/// `verdicts` is empty for a run that has no result; the outcome then says why.
std::string simulation_json(const parameters::Case& c, const integration::Motion& motion, const integration::Cost& cost,
                            std::span<const classification::Verdict> verdicts);

/// Returns "stridor.stability/1": case and, per direction, kind, growth, frequency and modes, the same at each point
/// along the parameter, and the boundaries between kinds.
std::string stability_json(const analysis::StabilityScan& scan);

/// Returns the records that these documents are made of and whose values have units, for the types of the page.
std::vector<DescribedRecord> simulation_records();

}  // namespace stridor::io
