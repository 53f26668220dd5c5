#pragma once

#include "stridor/classification/compared_sound.hpp"
#include "stridor/crew/crew.hpp"
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

/// The cells of a chart that sound most like a recording.
///
/// A chart of few cells is heard whole. In a larger one every n-th point of both axes is heard first, the ends
/// included. Then n is halved again and again down to 1. Each time the neighbours of the best cells so far follow,
/// until the neighbours of all best cells are known. A small region between the points of the first grid may be missed:
/// `SearchExtent::every` hears all cells. The choice depends on the chart and the recording alone, never on the crew.
namespace stridor::hearing {

/// Whether the best cells are searched, or every cell is heard.
enum class SearchExtent { search, every };

/// The progress of a search.
struct SearchProgress {
    std::size_t done = 0;    // [1] cells heard
    std::size_t before = 0;  // [1] of them, those kept by an earlier run
    std::size_t known = 0;   // [1] cells asked for so far: more follow from their sounds
};

/// How a chart is searched.
struct SoundSearch {
    SearchExtent extent = SearchExtent::search;
    std::size_t keep = 5;          // [1] of the best cells
    std::size_t first_grid = 400;  // [1] most cells of the first grid
    classification::LevelUse level = classification::LevelUse::ignored;
    std::vector<bool> ruled_out{};                // cells that are not heard, shape [cell]; empty: none
    crew::CrewMaker crew = crew::thread_crews();  // the crew that computes
    std::stop_token stop{};
    storage::KeptResults* kept = nullptr;  // where cells are kept by their index, if anywhere; must outlive the search
    std::function<void(const SearchProgress&)> progress{};  // from the caller's thread
};

/// A cell beside the recording. In `likeness` the recording is the first, the cell the second.
struct SoundMatch {
    CellSound cell{};
    classification::Likeness likeness{};
};

/// The result of a search.
struct SoundSearchResult {
    std::vector<SoundMatch> best{};  // nearest first; of equals the one with the lower index
    std::size_t heard = 0;           // [1] cells heard
    std::size_t without_result = 0;  // [1] of them, those that are not done
    std::size_t ruled_out = 0;       // [1]
    bool is_stopped = false;         // then the result is incomplete
};

/// Returns all that decides the sounds of a study's cells, as text that identifies kept results.
std::string listening_text(const sweep::Study& study, const CellListening& listening);

/// Finds the cells nearest to a profile. Kept results are not computed again.
SoundSearchResult search(const sweep::Study& study, const classification::SoundProfile& recording,
                         const CellListening& listening, const SoundSearch& options);

// Requirements of a search by sound (`search`) on the recording, and the cells that it leaves out.

/// Throws `Error` (input) for a recording that is too short to be described, or silent.
void require_matchable(const classification::ComparedSound& recording);

/// Throws `Error` (input) unless the recording's level is one of the model's motion: a sound pressure would need a
/// model of radiation.
void require_comparable_level(const classification::ComparedSound& recording, signal::MotionQuantity quantity);

/// Returns the rate at which cells are rendered beside a recording [Hz]: its own, within 8 kHz to 192 kHz.
double matching_rate(const classification::ComparedSound& recording);

/// Returns which cells a store knows to be failed, or to be quiet although noise is heard; shape [cell].
///
/// Throws `Error` (io) if there is no store, and the errors of opening it.
std::vector<bool> ruled_out(const sweep::Study& study, const std::filesystem::path& store,
                            classification::Category heard);

/// Returns the cell of a match, as it was heard.
SimulatedSound simulated_of(const sweep::Study& study, const SoundMatch& match);

}  // namespace stridor::hearing
