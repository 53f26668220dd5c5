#pragma once

#include "stridor/analysis/evidence.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace stridor::analysis {

/// One number of a phase's evidence. The figures of a cell, and a verdict in JSON with its units, come from this table.
struct EvidenceFigure {
    std::string_view name;      // of a cell's figure, a word of lower-case letters, digits and underscores
    std::string_view key;       // where it stands in a verdict as JSON, "levels.joint.rms"
    std::string_view unit;      // "1", "Hz", "dB re 1e-9 m/s"
    std::string_view sentence;  // for attributes and colour bars
    double (*value)(const Evidence&);
    /// Is the value a whole number?
    enum class Holds : std::uint8_t { number, count } holds = Holds::number;
    /// Where the figure is told: every one in verdicts, most in cells, too.
    enum class Kept : std::uint8_t { in_cells, in_verdicts } kept = Kept::in_cells;
};

/// All of them, in the order of files.
std::span<const EvidenceFigure> evidence_figures();

/// Under which name a document gives the unit: figures side by side that have one unit share it.
///
/// The shares of an object do ("rates.slip" is in "rates"), and so do those of its bodies ("levels.joint.rms" is in
/// "levels.rms"). Empty for a count, which needs none.
std::string unit_key(const EvidenceFigure& figure);

}  // namespace stridor::analysis
