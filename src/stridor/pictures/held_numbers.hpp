#pragma once

#include "stridor/drawing/scene.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace stridor::pictures {

/// A number held against a published one.
struct HeldPoint {
    std::string label;        // what it is
    std::string numbers;      // both, as text
    std::size_t kind = 0;     // of the published one, an index into `kinds`
    double precision = 0.0;   // [1] of the published one, as a share of it, above 0
    double difference = 0.0;  // [1] of ours from it, as a share of it, without sign
};

/// Draws a row for each number: how well the published one is known, as a bar, and how far ours lies from it, as a
/// point. A bar that reaches beyond its point is an agreement. `kinds` names the kinds, five at most.
drawing::Scene held_numbers(std::span<const HeldPoint> points, std::span<const std::string_view> kinds);

}  // namespace stridor::pictures
