#pragma once

#include "stridor/advice/design_runner.hpp"
#include "stridor/advice/design_space.hpp"
#include "stridor/advice/nearest_design.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What is said of a design before all else. Report, advice, page and Python take it from here, so that none of them
/// calls quiet what another one knows to be close to noise.
namespace stridor::advice {

// What lies close to a quiet design: a part is never made as it is drawn. Each quantity that a designer varies is
// changed alone, by shares of its value, and the nearest change that ends the silence is told.

/// By so much each quantity is changed, less and more [1, share of its value; of one that is zero, of its usual range].
inline constexpr std::array near_steps{0.001, 0.002, 0.0035, 0.005, 0.0075, 0.01, 0.02, 0.035, 0.05};

/// So far is looked [1].
inline constexpr double looked_within = near_steps.back();

/// A change of one quantity with which a quiet design is quiet no more.
struct NearChange {
    std::string key{};
    double relative = 0.0;    // [1] below 0: less of it; share of the value, or of the usual range where that is zero
    double value = 0.0;       // in the field's unit
    DesignVerdict verdict{};  // there
};

/// What was found within `looked_within`; every change has the quantity's own key, of all of them, not of a space's.
struct Neighbourhood {
    std::vector<NearChange> turns{};  // nearest first, at most one to each side of a quantity
};

/// Looks around a quiet design. Both sides of a change that it finds are 0.0005 of the value apart, at most.
Neighbourhood neighbourhood(const DesignSpace& space, DesignRunner& runner);

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
