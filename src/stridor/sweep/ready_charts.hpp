#pragma once

#include "stridor/sweep/study.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::sweep {

/// What a chart belongs to: a user's file, the paper's planes, or the planes of soft parts.
enum class PlaneSet { file, paper, soft };

inline constexpr std::array<std::string_view, 3> plane_set_names{"file", "paper", "soft"};

/// A chart that the program brings along.
struct ReadyChart {
    std::string name;  // "noise-chart", as `stridor init` has it
    PlaneSet set = PlaneSet::paper;
    Study study;
};

/// The paper's planes (Figure 8, and Figure 6 at 70 deg), then those of the soft parts.
std::vector<ReadyChart> ready_charts();

}  // namespace stridor::sweep
