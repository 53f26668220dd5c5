#pragma once

#include "stridor/classification/category.hpp"
#include "stridor/hearing/heard_recordings.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// How well the ear does on recordings that somebody has labelled.
namespace stridor::hearing {

/// So many of so many, with what chance leaves of it. Recordings of one source are no independent witnesses: the
/// interval comes from drawing sources again, with replacement (cluster bootstrap, Davison and Hinkley 1997, section
/// 3.8), 2000 times with a fixed seed.
struct RightShare {
    std::string what;  // "creaks"
    std::size_t right = 0;
    std::size_t count = 0;
    double low = 0.0;   // [1] 2.5 % of the draws lie below
    double high = 0.0;  // [1] 2.5 % lie above
};

/// Recordings of about one probability.
struct CalibrationBin {
    double from = 0.0;  // [1] probability
    double to = 0.0;    // [1]
    std::size_t count = 0;
    std::size_t right = 0;
    double probability = 0.0;  // [1] their mean
};

/// What is left where the ear speaks from a probability on.
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
    std::vector<CalibrationBin> bins{};      // of those by the ear; none where all were heard by the rules
    std::vector<AbstentionPoint> decided{};  // likewise
};

/// The score of what was heard. Recordings are right where one of the expected categories is heard.
RecordingScore score_of(std::span<const HeardRecording> recordings);

}  // namespace stridor::hearing
