#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/sweep/cell.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace stridor::pictures {

/// The layers of one kind in a panel, in their order.
template <typename Kind>
std::vector<Kind> layers_of(const drawing::Panel& panel) {
    std::vector<Kind> found;
    for (const drawing::Layer& layer : panel.layers)
        if (const Kind* kind = std::get_if<Kind>(&layer)) found.push_back(*kind);
    return found;
}

/// A study over preload (log, 4 values) and kinetic friction (linear, 3 values), both directions.
inline sweep::Study small_study() {
    sweep::Study study;
    study.x = {"contact.preload", 1.0, 1000.0, 4, sweep::Scale::logarithmic};
    study.y = {"contact.kinetic_friction", 0.0, 0.6, 3, sweep::Scale::linear};
    return study;
}

/// Its cells, every one quiet.
inline std::vector<sweep::Cell> quiet_cells() {
    sweep::Cell cell;
    cell.status = sweep::Status::done;
    cell.category = classification::Category::none;
    set_figure(cell, sweep::cell_figure("slip"), 1.0);
    set_figure(cell, sweep::cell_figure("stick"), 0.0);
    set_figure(cell, sweep::cell_figure("separation"), 0.0);
    return {sweep::cell_count(small_study()), cell};
}

/// The sweep of these.
inline sweep::SweepResult quiet_sweep() {
    return sweep::complete(small_study(), quiet_cells());
}

}  // namespace stridor::pictures
