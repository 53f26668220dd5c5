#pragma once

#include "stridor/noise_library/add_recordings.hpp"
#include "stridor/parameters/case.hpp"

#include <functional>
#include <stop_token>
#include <string>

namespace stridor::noise_library {

/// How the starter noises come into a library.
struct StarterAdding {
    Probe probe{};
    std::function<std::string(const parameters::Case&)> case_text{};  // what files and entries say of a case
    std::stop_token stop{};
    std::function<void(const Entry& entry)> added = [](const Entry&) { /* as the library has it */ };
    std::function<void(double share, const std::string& name)> progress = [](double, const std::string&) {
        /* so much [1] is done, this file at last */
    };
};

/// Simulates the starter noises one after the other and adds their sounds; those the library has stay what they are.
///
/// One that was made before is known by its name and its case, and not made again. What ends it: a stop (`Error`,
/// interrupted), a case without a result, an error of the library. What is added by then stays.
Added add_starter(Library& library, const StarterAdding& adding);

}  // namespace stridor::noise_library
