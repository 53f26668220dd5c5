#pragma once

#include "stridor/classification/recording_verdict.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/parameters/fields/sound_thresholds.hpp"
#include "stridor/signal/source.hpp"
#include "stridor/sound/analysis.hpp"
#include "stridor/storage/kept_results.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

/// Recordings by ear, compared with what people say they are.
namespace stridor::hearing {

/// What a person says a recording is.
struct Expectation {
    std::string file;                                    // with its folder
    std::string words;                                   // as they stand in the table: "squeak or creak"
    std::vector<classification::Category> categories{};  // any of these is right; never empty
    std::string source{};                                // who recorded it; recordings of one source are alike
    bool is_sure = true;                                 // whether the label is sure
};

/// A recording by ear.
struct HeardRecording {
    Expectation expectation;
    classification::Category heard = classification::Category::undecided;
    std::string reason;
    double probability = 0.0;  // [1] of the category, by the ear; 0: by the rules
};

/// Says whether it is heard as one of the expected categories.
bool is_right(const HeardRecording& recording);

/// Returns the verdict by ear on the loudest channel; reads the source to its end.
classification::RecordingVerdict verdict_on(signal::Source& source, const parameters::SoundThresholds& thresholds,
                                            const sound::AnalysisProgress& progress = {});

/// Returns all that decides the verdicts on these recordings, as text that identifies kept results. A file is named
/// with its size and the time of its last change; its bytes are not read.
std::string heard_text(std::span<const Expectation> expectations, const parameters::SoundThresholds& thresholds);

/// How recordings are heard.
struct RecordingHearing {
    parameters::SoundThresholds thresholds{};
    std::stop_token stop{};
    storage::KeptResults* kept = nullptr;  // verdicts kept by their place in the row, if any
    std::function<void(const std::string& file)> begin = [](const std::string&) { /* of a file */ };
    std::function<void(double share)> progress = [](double) { /* [1] of the file that was begun */ };
    std::function<void()> end = [] { /* of a file */ };
};

/// Hears one recording after the other; kept verdicts are not computed again.
///
/// Throws `Error` (interrupted) when it is stopped, and the errors of reading a recording.
std::vector<HeardRecording> hear(std::span<const Expectation> expectations, const RecordingHearing& hearing);

// How well the ear judges labelled recordings.

/// A number of right verdicts out of a count, with its confidence interval. Recordings of one source are not
/// independent: the interval comes from drawing sources again, with replacement (cluster bootstrap, Davison and Hinkley
/// 1997, section 3.8), 2000 times with a fixed seed.
struct RightShare {
    std::string what;  // "creaks"
    std::size_t right = 0;
    std::size_t count = 0;
    double low = 0.0;   // [1] 2.5 % of the draws lie below
    double high = 0.0;  // [1] 2.5 % lie above
};

/// Recordings with similar probabilities.
struct CalibrationBin {
    double from = 0.0;  // [1] probability
    double to = 0.0;    // [1]
    std::size_t count = 0;
    std::size_t right = 0;
    double probability = 0.0;  // [1] their mean
};

/// The verdicts that remain if the ear decides only from a probability on.
struct AbstentionPoint {
    double probability = 0.0;  // [1]
    std::size_t decided = 0;
    std::size_t right = 0;  // of these
};

/// A row of the table of what was heard, by what was expected: "squeak or creak".
struct HeardRow {
    std::string expected;
    std::array<std::size_t, classification::category_names.size()> heard{};
};

struct RecordingScore {
    std::vector<RightShare> shares{};
    std::vector<HeardRow> rows{};            // the expectations in the order they come
    std::vector<CalibrationBin> bins{};      // of those by the ear; empty if all were heard by the rules
    std::vector<AbstentionPoint> decided{};  // of those by the ear; empty if all were heard by the rules
};

/// Returns the score of the verdicts. A recording is right if one of its expected categories is heard.
RecordingScore score_of(std::span<const HeardRecording> recordings);

}  // namespace stridor::hearing
