#pragma once

#include "stridor/crew/thread_crew.hpp"
#include "stridor/hearing/hearing.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/storage/kept_results.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::hearing {

// What was heard as text, to be kept while a long evaluation or search goes on: read back it is the same, bit for bit.

/// The text of one sound.
std::string packed(const CellSound& sound);

/// The text of several.
std::string packed(std::span<const HeardSound> sounds);

/// The sound of such a text; nothing for text that is none.
std::optional<CellSound> unpacked_cell_sound(std::string_view text);

/// Likewise, of several.
std::optional<std::vector<HeardSound>> unpacked_heard_sounds(std::string_view text);

/// How the cells of a study are heard.
struct HearingOptions {
    HearingSettings settings{};
    std::size_t perturb_every = 7;                // [1] every so many runs' sounds are perturbed too; 0: none are
    crew::CrewMaker crew = crew::thread_crews();  // who computes
    std::stop_token stop{};
    storage::KeptResults* kept =
        nullptr;  // where runs are kept by their first index, if anywhere; must outlive the hearing
    std::function<void(const sweep::Progress&)>
        progress{};  // called from the caller's thread, at most ten times a second
};

/// All that decides what is heard of a study, as text: for what is kept of it.
std::string heard_text(const sweep::Study& study, const HearingOptions& options);

/// The hearing of a study's runs as the work of a crew: a task is a run by the index of its first cell, and its result
/// what is kept of it. Study and options must outlive the crew.
crew::Work work_of(const sweep::Study& study, const HearingOptions& options);

/// Judges every cell of a study by its contact states and by ear; in index order, empty if it was stopped. What is kept
/// is not heard again.
///
/// The same result for every crew. A study's refinement is not looked at: every cell is heard. Throws
/// `Error` (input) for a study with several starts, of which one could be heard only, and what `check_audible` throws.
std::vector<HeardSound> hear(const sweep::Study& study, const HearingOptions& options);

/// One of Table 1's cases by ear.
struct HeardCase {
    std::string name;                                                      // "squeal"
    std::vector<HeardSound> phases;                                        // going, coming
    classification::Category whole = classification::Category::undecided;  // the whole second, all phases as they come
    std::string reason;                                                    // why the whole sounds so
};

/// Hears the cases of Table 1: their phases, and the whole motion as one sound, as `stridor listen` makes it audible.
/// Throws `Error` (interrupted) where it was stopped.
std::vector<HeardCase> hear_table_1(const HearingOptions& options);

/// Throws the `Error` (interrupted) of sounds that are kept as they are heard: "stopped in Table 1 ...".
[[noreturn]] void throw_stopped(const std::string& where);

}  // namespace stridor::hearing
