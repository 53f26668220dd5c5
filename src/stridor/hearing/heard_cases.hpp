#pragma once

#include "stridor/hearing/hearing_run.hpp"

#include <string>
#include <vector>

namespace stridor::hearing {

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
