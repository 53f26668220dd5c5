#pragma once

#include "stridor/classification/category.hpp"
#include "stridor/sweep/study.hpp"

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::sweep {

/// How a cell ended. Only a done cell has figures; the others are drawn hatched and never guessed.
enum class Status {
    done,
    invalid,     // the axes' values contradict each other there (mu_d > mu_s)
    step_limit,  // the time step is unstable there
    diverged,    // a number left double precision
    failed,      // no valid start or contact forces exist (sprag-slip, Painleve)
};

inline constexpr std::array<std::string_view, 5> status_names{"done", "invalid", "step_limit", "diverged", "failed"};

/// What is kept of one cell in one direction.
struct Cell {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    Status status = Status::failed;
    classification::Category category = classification::Category::undecided;  // meaningless unless done
    std::string message;  // why it is not done, or done and undecided; empty otherwise

    double slip = unknown;               // [1] whole window
    double stick = unknown;              // [1]
    double separation = unknown;         // [1]
    double judged_slip = unknown;        // [1] judged part of the window
    double judged_stick = unknown;       // [1]
    double judged_separation = unknown;  // [1]
    double regularity = unknown;         // [1]
    double repetition = unknown;         // [1]
    double variation = unknown;          // [1]
    double intervals = unknown;          // [1]
    double lag = unknown;                // [1]
    double period = unknown;             // [s]
    double frequency = unknown;          // [Hz]
    double joint_rms = unknown;          // [m/s]
    double joint_peak = unknown;         // [m/s]
    double joint_level = unknown;        // [dB re 1e-9 m/s]
    double plate_rms = unknown;          // [m/s]
    double plate_peak = unknown;         // [m/s]
    double plate_level = unknown;        // [dB re 1e-9 m/s]
    double growth_rate = unknown;        // [1/s] of steady sliding
    double mode_frequency = unknown;     // [Hz] of the mode with it
    double energy_residual = unknown;    // [1] relative
    double proof_time = unknown;         // [s] from which the rest was proven; NaN: simulated to the end
};

/// One number of a cell; the store's columns, CSV, netCDF and what a chart can draw all come from this table. A name is
/// a word of lower-case letters, digits and underscores.
struct CellFigure {
    std::string_view name;
    std::string_view unit;      // "1", "Hz", "dB re 1e-9 m/s"
    std::string_view sentence;  // for attributes and colour bars
    double Cell::*member;
};

std::span<const CellFigure> cell_figures();

/// The figure with this name; nothing if there is none.
const CellFigure* find_cell_figure(std::string_view name);

/// A finished sweep: cells in index order (see `place_of`).
struct SweepResult {
    Study study;
    std::vector<Cell> cells;
};

}  // namespace stridor::sweep
