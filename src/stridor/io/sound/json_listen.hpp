#pragma once

#include "stridor/parameters/case.hpp"

#include <string>

namespace stridor::io {

/// A sound that was made of a simulated motion.
struct SoundInfo {
    std::string file;         // empty: it was played
    std::string player;       // the program that plays it; empty: it was written
    std::string cell;         // of which chart's cell, in words; empty: of a case
    std::string of;           // "joint", "plate", or a name
    std::string component;    // "x": along, "y": across the contact; empty: of a row
    std::string quantity;     // "velocity", "acceleration"
    std::string direction;    // "whole", "going", "coming"
    std::string part;         // "all", "judged"
    std::string level;        // "normalised", "absolute"
    std::string unit;         // of peak, rms and full_scale
    double rate = 0.0;        // [Hz]
    double duration = 0.0;    // [s]
    double high_pass = 0.0;   // [Hz]
    double peak = 0.0;        // [unit]
    double rms = 0.0;         // [unit]
    double full_scale = 1.0;  // [unit] the largest number of the file
};

/// "stridor.listen/1": the case and what was made of it.
std::string listen_json(const parameters::Case& c, const SoundInfo& sound);

}  // namespace stridor::io
