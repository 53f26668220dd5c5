#pragma once

#include "stridor/noise_library/add_recordings.hpp"
#include "stridor/parameters/case.hpp"

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::noise_library {

/// A first noise of the library: the rubbing parts, their operation, and the case of the sound.
struct StarterNoise {
    std::string_view system;     // "wiper"
    std::string_view parts;      // "blade / windscreen"
    std::string_view materials;  // "rubber / glass"
    std::string_view operation;  // "dry glass, slow"
    double temperature = 23.0;   // [degC] at which the friction coefficients hold
    double humidity = 50.0;      // [%]
    parameters::Case c{};
};

/// Returns noises like those of the paper's database: 56 noises of 22 systems of a car, those of one system together.
///
/// The paper has about forty recorded noises of about twenty systems and prints none of their parameters. Each noise
/// here is a variant of a ready kind: Table 1 or a soft part (`soft_part`). All numbers are estimates; no category is
/// among them. docs/methods/starter-noises.md.
std::vector<StarterNoise> starter_noises();

/// How the starter noises are added to a library.
struct StarterAdding {
    Probe probe{};
    std::function<std::string(const parameters::Case&)> case_text{};  // the text of a case in files and entries
    std::stop_token stop{};
    std::function<void(const Entry& entry)> added = [](const Entry&) { /* as the library has it */ };
    std::function<void(double share, const std::string& name)> progress = [](double, const std::string&) {
        /* so much [1] is done, this file at last */
    };
};

/// Simulates the starter noises one after the other and adds their sounds; those that the library has stay as they are.
///
/// A noise that was made before is recognised by its name and its case, and not made again. It ends early at a stop
/// (`Error`, interrupted), a case without a result, an error of the library. All added entries stay.
Added add_starter(Library& library, const StarterAdding& adding);

}  // namespace stridor::noise_library
