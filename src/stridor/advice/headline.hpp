#pragma once

#include "stridor/advice/design_runner.hpp"
#include "stridor/advice/design_space.hpp"
#include "stridor/advice/nearest_design.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The first line about a design. Report, advice, page and Python take it from here, so that none of them calls quiet
/// what another one shows to be close to noise.
namespace stridor::advice {

// The changes of verdict close to a quiet design: no part is made exactly as drawn. Each quantity that a designer
// varies is changed alone, by shares of its value, and the nearest change that ends the silence is reported.

/// The steps by which each quantity is changed, less and more [1, share of its value; if that is zero, of its usual
/// range].
inline constexpr std::array near_steps{0.001, 0.002, 0.0035, 0.005, 0.0075, 0.01, 0.02, 0.035, 0.05};

/// The farthest step [1].
inline constexpr double looked_within = near_steps.back();

/// A change of one quantity that ends the silence of a quiet design.
struct NearChange {
    std::string key{};
    double relative = 0.0;    // [1] below 0: less of it; share of the value, or of the usual range if that is zero
    double value = 0.0;       // in the field's unit
    DesignVerdict verdict{};  // at that value
};

/// The changes found within `looked_within`; each has the quantity's own key in the list of all keys, not in a space's.
struct Neighbourhood {
    std::vector<NearChange> turns{};  // nearest first, at most one to each side of a quantity
};

/// Looks around a quiet design. Both sides of a change that it finds are at most 0.0005 of the value apart.
Neighbourhood neighbourhood(const DesignSpace& space, DesignRunner& runner);

/// The standing of a design.
enum class Standing {
    quiet,         // also within `looked_within`
    barely_quiet,  // a change of one quantity within `looked_within` ends it
    quiet_here,    // the designs around it were not examined
    not_quiet,     // it makes noise, or could not be judged
};

inline constexpr std::array<std::string_view, 4> standing_names{"quiet", "barely_quiet", "quiet_here", "not_quiet"};

/// Returns the standing of a design. `near` holds the changes found around it; `std::nullopt` if nobody looked.
Standing standing(const DesignVerdict& present, const std::optional<Neighbourhood>& near);

/// Returns the standing in a few words: "quiet, but only just: 0.2 % more preload squeals while coming"; "squeals while
/// coming, is quiet while going".
std::string headline(const DesignSpace& space, const DesignVerdict& present, const std::optional<Neighbourhood>& near);

/// Returns a change in words: "0.2 % more preload".
std::string change_words(const NearChange& change);

/// Returns each turn of a neighbourhood in words, "0.23 % less preload (5.986 N) squeals while coming"; empty if there
/// is none.
std::vector<std::string> turn_words(const DesignSpace& space, const Neighbourhood& near);

/// Returns where the nearest design lies and how far that is: "contact.preload 6 -> 6.014 N, joint.mass 0.1 -> 0.102 kg
/// (0.025 % of their ranges away)"; of the quantities that change most.
std::string nearest_words(const DesignSpace& space, const NearestDesign& nearest);

/// Returns how closely ranges were searched: "Each range was looked at in 64 steps, ...".
std::string scan_words();

/// Returns the name of a quantity as people say it: "preload", "plate mass", "preload of lip2".
std::string quantity_words(std::string_view key);

}  // namespace stridor::advice
