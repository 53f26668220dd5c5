#pragma once

#include "stridor/classification/verdict.hpp"
#include "stridor/hearing/heard_recordings.hpp"
#include "stridor/hearing/hearing_run.hpp"
#include "stridor/sweep/ready_charts.hpp"

#include <optional>
#include <string>
#include <vector>

namespace stridor::io {

/// A chart by ear.
struct HeardChart {
    std::string name;  // of its file, or as `stridor init` calls a built-in one
    sweep::PlaneSet set = sweep::PlaneSet::file;
    sweep::Study study;
    std::vector<hearing::HeardSound> sounds{};  // shape [cell]
};

/// How well the ear and what it is held against agree.
struct HearingReport {
    hearing::HearingOptions options{};
    std::vector<hearing::HeardCase> cases{};
    std::vector<HeardChart> charts{};
    std::vector<hearing::HeardRecording> recordings{};
};

/// Returns the built-in charts of a set ("paper", "soft", or "all"), their cases changed by overrides ("KEY=VALUE"),
/// with no sounds yet. Throws `Error` (input) for an override that does not fit.
std::vector<HeardChart> built_in_charts(std::string_view set, const std::vector<std::string>& overrides);

/// Counts the sounds of all charts, one chart after the other, by their indices within each.
classification::Confusion confusion(const HearingReport& report, hearing::Half half = hearing::Half::both);

/// Counts perturbed sounds of all charts: those of one perturbation, or of all if none is given.
classification::Confusion perturbed_confusion(const HearingReport& report, std::optional<std::size_t> perturbation);

/// Counts the sounds of the charts of one set.
classification::Confusion confusion(const HearingReport& report, sweep::PlaneSet set);

/// Returns the sets that the report has charts of, in the order of `sweep::PlaneSet`.
std::vector<sweep::PlaneSet> sets_of(const HearingReport& report);

/// Returns "stridor.evaluate/1": Table 1, the tables of each chart, of each set and of all together, of both halves and
/// after each perturbation, and the recordings; thresholds.
std::string hearing_json(const HearingReport& report);

/// Returns "stridor.evaluate/1": a row per sound of the charts: where it is, both verdicts, figures of both, why it
/// sounds so, and the verdicts by ear after each perturbation (empty where it was not perturbed), and the chart's name.
std::string hearing_csv(const HearingReport& report);

}  // namespace stridor::io
