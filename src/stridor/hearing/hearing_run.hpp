#pragma once

#include "stridor/crew/crew.hpp"
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

// Verdicts on sounds as text, kept during a long evaluation or search. They read back bit for bit.

/// Returns the text of one sound.
std::string packed(const CellSound& sound);

/// Returns the text of several sounds.
std::string packed(std::span<const HeardSound> sounds);

/// Returns the sound of such a text, or `std::nullopt` for any other text.
std::optional<CellSound> unpacked_cell_sound(std::string_view text);

/// Returns the sounds of such a text, or `std::nullopt` for any other text.
std::optional<std::vector<HeardSound>> unpacked_heard_sounds(std::string_view text);

/// How the cells of a study are made audible and judged.
struct HearingOptions {
    HearingSettings settings{};
    std::size_t perturb_every = 7;                // [1] the sounds of one run in so many are perturbed too; 0: none
    crew::CrewMaker crew = crew::thread_crews();  // the crew that computes
    std::stop_token stop{};
    storage::KeptResults* kept =
        nullptr;  // where runs are kept by their first index, if anywhere; must outlive the hearing
    std::function<void(const sweep::Progress&)>
        progress{};  // called from the caller's thread, at most ten times a second
};

/// Returns all that decides the sounds of a study, as text that identifies kept results.
std::string heard_text(const sweep::Study& study, const HearingOptions& options);

/// Returns the hearing of a study's runs as the work of a crew: a task is a run by the index of its first cell, and its
/// result is the text to be kept. Study and options must outlive the crew.
crew::Work work_of(const sweep::Study& study, const HearingOptions& options);

/// Judges every cell of a study by its contact states and by ear; in index order, empty if it was stopped. Kept results
/// are not computed again.
///
/// The result does not depend on the crew. A study's refinement is ignored: every cell is heard. Throws `Error` (input)
/// for a study with several starts, of which only one could be heard, and what `check_audible` throws.
std::vector<HeardSound> hear(const sweep::Study& study, const HearingOptions& options);

/// One of Table 1's cases by ear.
struct HeardCase {
    std::string name;                                                      // "squeal"
    std::vector<HeardSound> phases;                                        // going, coming
    classification::Category whole = classification::Category::undecided;  // the whole second, all phases as they come
    std::string reason;                                                    // why the whole sounds so
};

/// Hears the cases of Table 1: their phases, and the whole motion as one sound, as `stridor listen` makes it audible.
/// Throws `Error` (interrupted) if it was stopped.
std::vector<HeardCase> hear_table_1(const HearingOptions& options);

/// Throws the `Error` (interrupted) for sounds that are kept as they are heard: "stopped in Table 1 ...".
[[noreturn]] void throw_stopped(const std::string& where);

}  // namespace stridor::hearing
