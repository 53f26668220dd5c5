#pragma once

#include "stridor/classification/category.hpp"
#include "stridor/classification/sound_verdict.hpp"
#include "stridor/parameters/sound_thresholds.hpp"
#include "stridor/signal/source.hpp"
#include "stridor/sound/analysis.hpp"
#include "stridor/storage/kept_results.hpp"

#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

/// Recordings by ear, held against what somebody says they are.
namespace stridor::hearing {

/// What somebody says a recording is.
struct Expectation {
    std::string file;                                    // with its folder
    std::string words;                                   // as they stand in the table: "squeak or creak"
    std::vector<classification::Category> categories{};  // any of these is right; never empty
    std::string source{};                                // whose it is; recordings of one source are alike
    bool is_sure = true;                                 // is somebody sure of the label?
};

/// A recording by ear.
struct HeardRecording {
    Expectation expectation;
    classification::Category heard = classification::Category::undecided;
    std::string reason;
    double probability = 0.0;  // [1] of the category, by the ear; 0: by the rules
};

/// Is it heard as one of the categories that are expected?
bool is_right(const HeardRecording& recording);

/// The verdict by ear on the loudest channel; reads the source to its end.
classification::RecordingVerdict verdict_on(signal::Source& source, const parameters::SoundThresholds& thresholds,
                                            const sound::AnalysisProgress& progress = {});

/// All that decides what is heard in these recordings, as text: for what is kept of them. A file stands in it with its
/// size and the time of its last change; its bytes are not read.
std::string heard_text(std::span<const Expectation> expectations, const parameters::SoundThresholds& thresholds);

/// How recordings are heard.
struct RecordingHearing {
    parameters::SoundThresholds thresholds{};
    std::stop_token stop{};
    storage::KeptResults* kept = nullptr;  // where verdicts are kept by their place in the row, if anywhere
    std::function<void(const std::string& file)> begin = [](const std::string&) { /* of a file */ };
    std::function<void(double share)> progress = [](double) { /* [1] of the file that was begun */ };
    std::function<void()> end = [] { /* of a file */ };
};

/// Hears one recording after the other; what is kept is not heard again.
///
/// Throws `Error`: interrupted when it is stopped, and what reading a recording throws.
std::vector<HeardRecording> hear(std::span<const Expectation> expectations, const RecordingHearing& hearing);

}  // namespace stridor::hearing
