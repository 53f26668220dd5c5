#pragma once

#include "stridor/parameters/case.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace stridor::noise_library {

/// A noise of the library to begin with: what rubs, how it is operated, and the case that it is the sound of.
struct StarterNoise {
    std::string_view system;     // "wiper"
    std::string_view parts;      // "blade / windscreen"
    std::string_view materials;  // "rubber / glass"
    std::string_view operation;  // "dry glass, slow"
    double temperature = 23.0;   // [degC] what the friction coefficients are meant for
    double humidity = 50.0;      // [%]
    parameters::Case c{};
};

/// The paper's database rebuilt in kind: 56 noises of 22 systems of a car, those of one system together.
///
/// The paper has about forty recorded noises of about twenty systems and prints none of their parameters. Each here is
/// a variant of a ready kind: Table 1 or a soft part (`soft_part`). All numbers are judgement; no category is among
/// them. docs/methods/starter-noises.md.
std::vector<StarterNoise> starter_noises();

}  // namespace stridor::noise_library
