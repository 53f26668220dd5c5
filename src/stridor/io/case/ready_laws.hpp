#pragma once

#include "stridor/sweep/study.hpp"

#include <span>
#include <string_view>

namespace stridor::io {

/// A soft part with a law of its own, of friction or of its stiffness, and its chart.
struct ReadyLaw {
    std::string_view name;
    std::string_view source;  // where the law comes from, and which of its numbers are estimates: a file's heading
    sweep::Study (*make)();
};

/// Returns the ready laws. wiper-wet: a lip on wet glass, Stribeck's curve. weatherstrip-falling: a trailing lip on
/// paint, a linear fall. seal-lip: a lip that stiffens as it is pressed.
std::span<const ReadyLaw> ready_laws();

}  // namespace stridor::io
