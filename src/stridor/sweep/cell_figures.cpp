#include "stridor/sweep/cell_figures.hpp"

#include "stridor/analysis/evidence_figures.hpp"
#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/base/check.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/integration/motion.hpp"

#include <array>
#include <limits>

namespace stridor::sweep {

namespace {

using analysis::EvidenceFigure;

/// What a cell keeps beside the evidence.
struct RunFigure {
    std::string_view name;
    std::string_view unit;
    std::string_view sentence;
    double (*value)(const JudgedRun&);
};

constexpr std::array run_figures{
    RunFigure{"growth_rate", "1/s", "largest growth rate of steady sliding; unstable above zero",
              [](const JudgedRun& run) { return run.stability.growth; }},
    RunFigure{"mode_frequency", "Hz", "frequency of the mode with the largest growth rate",
              [](const JudgedRun& run) { return run.stability.frequency; }},
    RunFigure{"energy_residual", "1", "energy the computation created or lost, as a share of the turnover",
              [](const JudgedRun& run) { return run.motion.energy.relative_residual(); }},
    RunFigure{"proof_time", "s", "time from which the rest of the motion was proven; none if it was simulated",
              [](const JudgedRun& run) {
                  return run.motion.outcome.reason == integration::Reason::settled
                             ? run.motion.outcome.time
                             : std::numeric_limits<double>::quiet_NaN();
              }},
};

std::vector<CellFigure> all_figures() {
    std::vector<CellFigure> figures;
    for (const EvidenceFigure& figure : analysis::evidence_figures())
        if (figure.kept == EvidenceFigure::Kept::in_cells)
            figures.push_back({figure.name, figure.unit, figure.sentence, figures.size()});
    for (const RunFigure& figure : run_figures)
        figures.push_back({figure.name, figure.unit, figure.sentence, figures.size()});
    return figures;
}

}  // namespace

std::span<const CellFigure> cell_figures() {
    static const std::vector<CellFigure> figures = all_figures();
    return figures;
}

const CellFigure* find_cell_figure(std::string_view name) {
    return base::find_named(cell_figures(), name);
}

const CellFigure& cell_figure(std::string_view name) {
    const CellFigure* figure = find_cell_figure(name);
    STRIDOR_EXPECT(figure != nullptr);
    return *figure;
}

std::vector<double> figures_of(const JudgedRun& run) {
    std::vector<double> values;
    values.reserve(cell_figures().size());
    for (const EvidenceFigure& figure : analysis::evidence_figures())
        if (figure.kept == EvidenceFigure::Kept::in_cells) values.push_back(figure.value(run.evidence));
    for (const RunFigure& figure : run_figures)
        values.push_back(figure.value(run));
    return values;
}

}  // namespace stridor::sweep
