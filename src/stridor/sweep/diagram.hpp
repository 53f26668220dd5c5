#pragma once

#include "stridor/crew/crew.hpp"
#include "stridor/storage/kept_results.hpp"
#include "stridor/sweep/cell.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

/// The content of a diagram over one parameter besides the category: how far the joint moves to and fro, and how long
/// its beats are (a bifurcation diagram).
namespace stridor::sweep {

/// Values of a cell closer than this share [1] of its range of values count as one: they are one point on paper.
inline constexpr double diagram_resolution = 0.01;

/// One column of points of a bifurcation diagram.
struct DiagramCell {
    std::vector<double> extremes;  // [m] local extremes of the joint's x1 in the judged time, rising; empty: stick
    std::vector<double>
        intervals;  // [s] between the beats of the verdict (analysis::Alternation), rising; may be empty
};

/// How a diagram is computed.
struct DiagramOptions {
    crew::CrewMaker crew = crew::thread_crews();  // the crew that computes
    std::stop_token stop{};
    storage::KeptResults* kept = nullptr;          // the cells kept, by index; must outlive the call
    std::function<void(double share)> progress{};  // from the caller's thread, ten times a second
};

/// Returns the diagram of a finished sweep over one axis; shape [cell], empty for a cell without a result and for a
/// contact that sticks for good. Each cell is run again with its trace, sampled every 20 us or 200,000 times, from the
/// start that it shows. The result does not depend on the crew. Throws `Error` (interrupted) when stopped.
std::vector<DiagramCell> diagram(const SweepResult& result, const DiagramOptions& options);

/// Returns all that decides a diagram, as text that identifies its kept results.
std::string diagram_text(const Study& study);

/// Returns the runs of a diagram as the work of a crew: a task is a cell by its index, with the start from which it is
/// run. The study must outlive the crew.
crew::Work diagram_work(const Study& study);

/// Returns a cell as text, to be kept.
std::string packed(const DiagramCell& cell);

/// Returns the cell in such a text, bit for bit, or `std::nullopt` for any other text.
std::optional<DiagramCell> unpacked_diagram_cell(std::string_view text);

}  // namespace stridor::sweep
