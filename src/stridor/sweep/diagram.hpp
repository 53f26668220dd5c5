#pragma once

#include "stridor/crew/thread_crew.hpp"
#include "stridor/storage/kept_results.hpp"
#include "stridor/sweep/cell.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

/// What a diagram over one parameter shows of each cell beside its category: how far the joint moves to and fro, and
/// how long its beats are (a bifurcation diagram).
namespace stridor::sweep {

/// Values closer than this share [1] of what a cell's values span are one: they cannot be told apart on paper.
inline constexpr double diagram_resolution = 0.01;

/// One column of points of a bifurcation diagram.
struct DiagramCell {
    std::vector<double> extremes;  // [m] local extremes of the joint's x1 in the judged time, rising; none if it sticks
    std::vector<double>
        intervals;  // [s] between the beats of the verdict (analysis::Alternation), rising; may be empty
};

/// How a diagram is computed.
struct DiagramOptions {
    crew::CrewMaker crew = crew::thread_crews();  // who computes
    std::stop_token stop{};
    storage::KeptResults* kept = nullptr;          // where cells are kept by their index; must outlive the call
    std::function<void(double share)> progress{};  // from the caller's thread, ten times a second
};

/// The diagram of a finished sweep over one axis; shape [cell], empty ones where a cell has no result or the contact
/// sticks for good. Each cell is run again with its trace, sampled every 20 us or 200,000 times, from the start that it
/// shows. The same for every crew. Throws `Error` (interrupted) when stopped.
std::vector<DiagramCell> diagram(const SweepResult& result, const DiagramOptions& options);

/// All that decides a diagram, as text: for what is kept of it.
std::string diagram_text(const Study& study);

/// The runs of a diagram as the work of a crew: a task is a cell by its index, and says from which start it is run. The
/// study must outlive the crew.
crew::Work diagram_work(const Study& study);

/// A cell as text, to be kept.
std::string packed(const DiagramCell& cell);

/// The cell of such a text, bit for bit; nothing for text that is none.
std::optional<DiagramCell> unpacked_diagram_cell(std::string_view text);

}  // namespace stridor::sweep
