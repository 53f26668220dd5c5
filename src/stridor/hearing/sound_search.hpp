#pragma once

#include "stridor/classification/compared_sound.hpp"
#include "stridor/crew/thread_crew.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/hearing/sound_comparison.hpp"
#include "stridor/signal/band_limit.hpp"
#include "stridor/storage/kept_results.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

/// Which cells of a chart sound most like a recording.
///
/// A chart of few cells is listened to whole. Of a larger one every n-th point of both axes is first, the ends
/// included. Then n is halved again and again down to 1. Each time the neighbours of the best cells so far follow,
/// until those of all best ones are known. A small region between the points of the first grid may be missed:
/// `SearchExtent::every` listens to all. What is listened to follows from the chart and the recording alone, never from
/// who computes.
namespace stridor::hearing {

/// Are the best cells searched for, or is every cell listened to?
enum class SearchExtent { search, every };

/// How far a search is.
struct SearchProgress {
    std::size_t done = 0;    // [1] cells listened to
    std::size_t before = 0;  // [1] of them, those that were kept by an earlier run
    std::size_t known = 0;   // [1] cells asked for so far: more follow from what they sound like
};

/// How a chart is searched.
struct SoundSearch {
    SearchExtent extent = SearchExtent::search;
    std::size_t keep = 5;          // [1] of the best cells
    std::size_t first_grid = 400;  // [1] most cells of the first grid
    classification::LevelUse level = classification::LevelUse::ignored;
    std::vector<bool> ruled_out{};                // cells that are not listened to, shape [cell]; empty: none
    crew::CrewMaker crew = crew::thread_crews();  // who computes
    std::stop_token stop{};
    storage::KeptResults* kept = nullptr;  // where cells are kept by their index, if anywhere; must outlive the search
    std::function<void(const SearchProgress&)> progress{};  // from the caller's thread
};

/// A cell beside the recording. In `likeness` the recording is the first, the cell the second.
struct SoundMatch {
    CellSound cell{};
    classification::Likeness likeness{};
};

/// What a search has found.
struct SoundSearchResult {
    std::vector<SoundMatch> best{};  // nearest first, of equals the one with the lower index
    std::size_t heard = 0;           // [1] cells listened to
    std::size_t without_result = 0;  // [1] of them, those that are not done
    std::size_t ruled_out = 0;       // [1]
    bool is_stopped = false;         // then nothing of the rest is complete
};

/// All that decides what the cells of a study sound like, as text: for what is kept of them.
std::string listening_text(const sweep::Study& study, const CellListening& listening);

/// Finds the cells nearest to a profile. What is kept is not listened to again.
SoundSearchResult search(const sweep::Study& study, const classification::SoundProfile& recording,
                         const CellListening& listening, const SoundSearch& options);

// What a search by sound (`search`) asks of a recording, and what it leaves out of a chart.

/// Throws `Error` (input) for a recording that is too short to be described, or silent.
void require_matchable(const classification::ComparedSound& recording);

/// Throws `Error` (input) unless the recording's level is one of the model's motion: a sound pressure would need a
/// model of radiation.
void require_comparable_level(const classification::ComparedSound& recording, signal::MotionQuantity quantity);

/// The rate at which cells are rendered beside a recording: its own, within 8 kHz to 192 kHz [Hz].
double matching_rate(const classification::ComparedSound& recording);

/// The cells that a store knows to be failed, or quiet where noise is heard, shape [cell].
///
/// Throws `Error` (io) where there is no store, and what opening it throws.
std::vector<bool> ruled_out(const sweep::Study& study, const std::filesystem::path& store,
                            classification::Category heard);

/// The cell of a match, as what was listened to.
SimulatedSound simulated_of(const sweep::Study& study, const SoundMatch& match);

}  // namespace stridor::hearing
