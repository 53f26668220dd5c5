#pragma once

#include "stridor/noise_library/recording.hpp"

#include <cstddef>
#include <exception>
#include <filesystem>
#include <functional>
#include <stop_token>

namespace stridor::noise_library {

/// What becomes of a recording whose sound an entry has already.
enum class Known { skipped, added_again };

/// What becomes of a recording that is broken: it stands in `Arrivals`, or its error ends all.
enum class Refused { listed, thrown };

/// How recordings are added.
struct Adding {
    Entry given{};  // what is said of all
    Known known = Known::skipped;
    Refused refused = Refused::listed;
    Probe probe{};
    std::stop_token stop{};
    std::function<void(const std::filesystem::path& file)> begin{};  // of a file
    std::function<void(const Entry& entry)> added{};                 // as the library has it
    std::function<void()> end{};                                     // of a file
};

/// What became of them, also where an error ended it.
struct Added {
    Arrivals arrivals{};
    std::exception_ptr ended_by{};  // nothing if all is well
};

/// Adds one file after the other, past what is known and what is broken.
///
/// What ends it: a stop (`Error`, interrupted), an error of the library, and, after all are tried, a file that was
/// refused (`Error`, input). What is added by then stays.
Added add_recordings(Library& library, const recordings::RecordingFiles& files, const Adding& adding);

/// Throws `Error` (interrupted) if a stop is asked for with so many files left: for a probe that takes long.
void go_on(const std::stop_token& stop, std::size_t left);

}  // namespace stridor::noise_library
