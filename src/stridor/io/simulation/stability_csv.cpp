#include "stridor/io/simulation/stability_csv.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/io/csv_opening.hpp"
#include "stridor/model/sliding_motion.hpp"

#include <cmath>
#include <complex>
#include <limits>
#include <string_view>
#include <vector>

namespace stridor::io {

namespace {

using analysis::SlidingStability;
using base::csv_text::Table;

// what stands at the beginning of each row of one point
struct PointWords {
    std::string_view direction;
    const double* value = nullptr;  // of the parameter; none where none is followed
};

void add_row(Table& table, const PointWords& point, const SlidingStability& stability, const analysis::Eigenmode& mode,
             std::string_view grows) {
    table.word(point.direction);
    if (point.value != nullptr) table.number(*point.value);
    table.word(analysis::stability_names[static_cast<std::size_t>(stability.kind)]);
    table.number(mode.frequency);
    table.number(mode.growth);
    table.number(-mode.growth / std::hypot(mode.growth, base::two_pi * mode.frequency));
    table.word(grows);
    table.end_row();
}

void add_point(Table& table, const PointWords& point, const SlidingStability& stability) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    // without an equilibrium its modes are none
    if (stability.modes.empty() || stability.kind == analysis::StabilityKind::locked)
        return add_row(table, point, stability, {unknown, unknown}, "");
    std::vector<std::complex<double>> eigenvalues;
    for (const analysis::Eigenmode& mode : stability.modes)
        eigenvalues.emplace_back(mode.growth, base::two_pi * mode.frequency);
    const double rounding = model::growth_rounding(eigenvalues);
    for (const analysis::Eigenmode& mode : stability.modes)
        add_row(table, point, stability, mode, mode.growth > rounding ? "yes" : "no");
}

}  // namespace

std::string stability_csv(const analysis::StabilityScan& scan) {
    base::csv_text::Facts facts = csv_opening("modes", scan.base);
    add_lines(facts, parameters::canonical_text(scan.base));
    std::vector<base::csv_text::TableColumn> columns{
        {"direction"}, {"sliding"}, {"frequency", "Hz"}, {"growth", "1/s"}, {"damping_ratio", "1"}, {"grows"}};
    if (!scan.key.empty()) columns.insert(columns.begin() + 1, {scan.key, scan.unit});
    Table table(facts, columns);
    for (const analysis::DirectionScan& direction : scan.directions) {
        const std::string_view name = parameters::direction_names[static_cast<std::size_t>(direction.direction)];
        if (scan.key.empty()) add_point(table, {name}, direction.here);
        for (const analysis::StabilityPoint& point : direction.path.points)
            add_point(table, {name, &point.value}, point.stability);
    }
    return table.take();
}

}  // namespace stridor::io
