#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/sweep/cell.hpp"

#include <cstddef>
#include <string>
#include <vector>

/// How a cell's verdict is drawn: a kind for each category, for a contact that is quiet because it sticks, for one
/// that locks, and for cells without a result.
namespace stridor::pictures {

/// The kind of a cell, into `kind_fills` and `kind_names`.
std::size_t kind_of(const sweep::CellVerdict& cell);

/// The fill of each kind.
std::vector<drawing::Fill> kind_fills();

/// The name of each kind, as legends have it.
std::vector<drawing::StyledText> kind_names();

/// "failed (invalid, diverged)": which ways to fail occur; empty if none does.
std::string failure_words(const sweep::SweepResult& result);

/// Adds the four categories to the legend, and of the other kinds those that occur.
void add_kind_legend(drawing::Scene& scene, const sweep::SweepResult& result);

}  // namespace stridor::pictures
