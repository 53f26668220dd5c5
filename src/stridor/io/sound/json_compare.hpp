#pragma once

#include "stridor/classification/compared_sound.hpp"
#include "stridor/hearing/sound_search.hpp"

#include <span>
#include <string>

namespace stridor::io {

/// Returns "stridor.compare/1": each sound with where it is from, its categories and figures, and the distances of all
/// pairs with what they come from.
std::string compare_json(std::span<const classification::ComparedSound> sounds);

/// A recording, a chart, and the chart's cells that sound most like it.
struct MatchReport {
    classification::ComparedSound recording{};
    std::string chart{};  // its file
    sweep::Study study{};
    std::string motion{};  // "joint velocity along x"
    double rate = 0.0;     // [Hz] at which cells were rendered
    classification::LevelUse level = classification::LevelUse::ignored;
    hearing::SearchExtent extent = hearing::SearchExtent::search;
    hearing::SoundSearchResult result{};
};

/// Returns "stridor.match/1": the recording's figures, and of each match the cell, its categories and figures, the
/// distance and what it comes from.
std::string match_json(const MatchReport& report);

}  // namespace stridor::io
