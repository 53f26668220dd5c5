#pragma once

#include "stridor/advice/nearest_design.hpp"
#include "stridor/advice/neighbourhood.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What is said of a design before all else. Report, advice, page and Python take it from here, so that none of them
/// calls quiet what another one knows to be close to noise.
namespace stridor::advice {

/// How a design stands.
enum class Standing {
    quiet,         // and so within `looked_within`
    barely_quiet,  // a change of one quantity within `looked_within` ends it
    quiet_here,    // what lies around was not looked at
    not_quiet,     // it makes noise, or could not be judged
};

inline constexpr std::array<std::string_view, 4> standing_names{"quiet", "barely_quiet", "quiet_here", "not_quiet"};

/// Says how a design stands; `near` is what was found around it, `std::nullopt` where nobody looked.
Standing standing(const DesignVerdict& present, const std::optional<Neighbourhood>& near);

/// In a few words: "quiet, but only just: 0.2 % more preload squeals while coming"; "squeals while coming, is quiet
/// while going".
std::string headline(const DesignSpace& space, const DesignVerdict& present, const std::optional<Neighbourhood>& near);

/// "0.2 % more preload".
std::string change_words(const NearChange& change);

/// "0.23 % less preload (5.986 N) squeals while coming", of each turn of a neighbourhood; empty if there is none.
std::vector<std::string> turn_words(const DesignSpace& space, const Neighbourhood& near);

/// Where the nearest design lies and how far that is: "contact.preload 6 -> 6.014 N, joint.mass 0.1 -> 0.102 kg
/// (0.025 % of their ranges away)"; of the quantities that change most.
std::string nearest_words(const DesignSpace& space, const NearestDesign& nearest);

/// How closely ranges were looked at: "Each range was looked at in 64 steps, ...".
std::string scan_words();

/// A quantity as one says it: "preload", "plate mass", "preload of lip2".
std::string quantity_words(std::string_view key);

}  // namespace stridor::advice
