#pragma once

#include "stridor/classification/confusion.hpp"
#include "stridor/hearing/hearing_run.hpp"
#include "stridor/io/sound/expectations.hpp"
#include "stridor/sweep/study.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::io {

/// One of Table 1's cases by ear.
struct HeardCase {
    std::string name;                                                      // "squeal"
    std::vector<hearing::HeardSound> phases;                               // going, coming
    classification::Category whole = classification::Category::undecided;  // the whole second, all phases as they come
    std::string reason;                                                    // why the whole sounds so
};

/// What a chart belongs to: a user's file, the paper's planes, or the planes of soft parts.
enum class PlaneSet { file, paper, soft };

inline constexpr std::array<std::string_view, 3> plane_set_names{"file", "paper", "soft"};

/// A chart by ear.
struct HeardChart {
    std::string name;  // of its file, or as `stridor init` calls a built-in one
    PlaneSet set = PlaneSet::file;
    sweep::Study study;
    std::vector<hearing::HeardSound> sounds{};  // shape [cell]
};

/// A recording by ear.
struct HeardRecording {
    Expectation expectation;
    classification::Category heard = classification::Category::undecided;
    std::string reason;
};

/// How well the ear and what it is held against agree.
struct HearingReport {
    hearing::HearingOptions options{};
    std::vector<HeardCase> cases{};
    std::vector<HeardChart> charts{};
    std::vector<HeardRecording> recordings{};
};

/// The sounds of all charts, one chart after the other, counted by their indices within each.
classification::Confusion confusion(const HearingReport& report, hearing::Half half = hearing::Half::both);
classification::Confusion perturbed_confusion(const HearingReport& report, std::optional<std::size_t> perturbation);

/// The same of the charts of one set.
classification::Confusion confusion(const HearingReport& report, PlaneSet set);

/// The sets that the report has charts of, in the order of `PlaneSet`.
std::vector<PlaneSet> sets_of(const HearingReport& report);

bool is_right(const HeardRecording& recording);

/// "stridor.evaluate/1": Table 1, the tables of each chart, of each set and of all together, of both halves and after
/// each perturbation, and the recordings; thresholds.
std::string hearing_json(const HearingReport& report);

/// "stridor.evaluate/1": a row per sound of the charts: where it is, both verdicts, figures of both, why it sounds so,
/// and the verdicts by ear after each perturbation (empty where it was not perturbed), and the chart's name.
std::string hearing_csv(const HearingReport& report);

}  // namespace stridor::io
