#include "stridor/console/results/stability_text.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/results/text_table.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/system.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace stridor::console {

namespace {

using analysis::StabilityKind;

std::string kind_name(StabilityKind kind) {
    return std::string(analysis::stability_names[static_cast<std::size_t>(kind)]);
}

// of many modes those that grow most, by rising frequency
constexpr std::size_t most_modes_shown = 6;

std::string modes_text(const analysis::SlidingStability& stability) {
    std::vector<double> growths;
    for (const analysis::Eigenmode& mode : stability.modes)
        growths.push_back(mode.growth);
    std::sort(growths.rbegin(), growths.rend());
    const bool is_long = growths.size() > most_modes_shown;
    const double least = is_long ? growths[most_modes_shown - 1] : -std::numeric_limits<double>::infinity();
    std::string text;
    std::size_t shown = 0;
    for (const analysis::Eigenmode& mode : stability.modes)
        if (mode.growth >= least && shown < most_modes_shown) {
            text += fmt::format("  {:9.2f} Hz {:+10.3f} 1/s", mode.frequency, mode.growth);
            ++shown;
        }
    if (is_long) text += fmt::format("  and {} that decay faster", growths.size() - shown);
    return text;
}

// contacts that steady sliding lifts off
std::string open_text(const parameters::Case& c, const analysis::SlidingStability& stability) {
    std::string text;
    for (const std::size_t contact : stability.open)
        text += (text.empty() ? "" : ", ") + base::visible(parameters::contact_name(c, contact));
    return text.empty() ? "" : "        separated: " + text + "\n";
}

// the least of several, or of an own structure, has no one preload to be a share of
std::string normal_force_text(const parameters::Case& c, double normal_force) {
    return parameters::has_named_contacts(c) ? fmt::format("N {:8.4g} N", normal_force)
                                             : fmt::format("N/F {:8.4f}", normal_force / c.contact().preload);
}

// of friction that changes with the slip velocity
std::string critical_velocity_text(const analysis::DirectionScan& direction) {
    if (!direction.critical_velocity) return {};
    const double velocity = *direction.critical_velocity;
    if (velocity == 0.0) return "        sliding lasts at any velocity\n";
    if (std::isinf(velocity)) return "        sliding lasts at no velocity\n";
    return fmt::format("        critical velocity {:.6g} m/s: below it sliding is lost\n", velocity);
}

std::string header(const analysis::StabilityScan& scan) {
    std::string text = styled("stability of steady sliding", Style::bold, STDOUT_FILENO) + "\n\n";
    for (const analysis::DirectionScan& direction : scan.directions) {
        const analysis::SlidingStability& here = direction.here;
        text += fmt::format("{:<8}{:<11}{}  modes{}\n",
                            parameters::direction_names[static_cast<std::size_t>(direction.direction)],
                            kind_name(here.kind), normal_force_text(scan.base, here.normal_force), modes_text(here));
        text += open_text(scan.base, here);
        text += critical_velocity_text(direction);
    }
    return text;
}

std::string boundary_lines(const analysis::StabilityScan& scan, const analysis::DirectionScan& direction) {
    std::string text;
    const std::string name(parameters::direction_names[static_cast<std::size_t>(direction.direction)]);
    if (direction.path.boundaries.empty())
        text += fmt::format("{:<8}{} throughout\n", name, kind_name(direction.path.points.front().stability.kind));
    for (const analysis::StabilityBoundary& boundary : direction.path.boundaries)
        text += fmt::format("{:<8}{} -> {} at {} = {:.5g}{} ({:.2f} Hz)\n", name, kind_name(boundary.below),
                            kind_name(boundary.above), scan.key, boundary.value, after_number(scan.unit),
                            boundary.frequency);
    return text;
}

constexpr std::size_t most_free_modes = 3;  // that a mode is said to be made of
constexpr std::size_t most_feeding = 8;     // contacts that are named, those that add or take most

std::string feeding_text(const parameters::Case& c, const analysis::SlidingMode& mode) {
    std::vector<std::size_t> contacts(mode.contact_growth.size());
    std::iota(contacts.begin(), contacts.end(), std::size_t{0});
    std::stable_sort(contacts.begin(), contacts.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(mode.contact_growth[a]) > std::abs(mode.contact_growth[b]);
    });
    std::string text;
    double rest = 0.0;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        if (k >= most_feeding)
            rest += mode.contact_growth[contacts[k]];
        else
            text += fmt::format("{} {:+.3f}, ", base::visible(parameters::contact_name(c, contacts[k])),
                                mode.contact_growth[contacts[k]]);
    }
    if (contacts.size() > most_feeding) text += fmt::format("{} more {:+.3f}, ", contacts.size() - most_feeding, rest);
    return text + fmt::format("damping {:+.3f} 1/s", mode.damping_growth);
}

// what the modes that grow are made of, and what feeds them
std::string contributions_text(const parameters::Case& c, const analysis::DirectionScan& direction) {
    const analysis::SlidingModes& modes = *direction.modes;
    std::string text;
    for (const analysis::SlidingMode& mode : modes.modes) {
        text += fmt::format("\n{:<8}{:9.2f} Hz {:+10.3f} 1/s\n",
                            parameters::direction_names[static_cast<std::size_t>(direction.direction)],
                            mode.eigenvalue.imag() / base::two_pi, mode.eigenvalue.real());
        const std::vector<std::size_t> numbers = analysis::by_share(mode);
        for (std::size_t k = 0; k < std::min(most_free_modes, numbers.size()); ++k)
            text += fmt::format("        free mode {:<4}{:9.2f} Hz  energy {:5.1f} %  MAC {:.3f}\n", numbers[k] + 1,
                                modes.free_frequencies[numbers[k]], 100.0 * mode.energy_shares[numbers[k]],
                                mode.mac[numbers[k]]);
        text += "        growth by " + feeding_text(c, mode) + "\n";
    }
    return text;
}

}  // namespace

std::string stability_text(const analysis::StabilityScan& scan) {
    std::string text = header(scan);
    for (const analysis::DirectionScan& direction : scan.directions)
        if (direction.modes) text += contributions_text(scan.base, direction);
    if (scan.key.empty()) return text;
    text += "\n";
    for (const analysis::DirectionScan& direction : scan.directions)
        text += boundary_lines(scan, direction);
    const std::string name = scan.key.substr(scan.key.rfind('.') + 1);
    const std::size_t width = std::max<std::size_t>(12, name.size());
    for (const analysis::DirectionScan& direction : scan.directions) {
        text += fmt::format("\n{:<8}{:>{}}  {:<11}modes (frequency, growth)\n",
                            parameters::direction_names[static_cast<std::size_t>(direction.direction)], name, width,
                            "kind");
        for (const analysis::StabilityPoint& point : direction.path.points)
            text += fmt::format("{:<8}{:>{}.6g}  {:<11}{}\n", "", point.value, width, kind_name(point.stability.kind),
                                modes_text(point.stability));
    }
    return text;
}

std::string starts_text(const sweep::SweepResult& result) {
    if (result.study.starts.empty()) return {};
    std::string text = fmt::format("from {} starts:", result.study.starts.size());
    for (std::size_t k = 0; k < sweep::agreement_names.size(); ++k) {
        const auto number = std::count_if(
            result.cells.begin(), result.cells.end(),
            [k](const sweep::CellVerdict& cell) { return static_cast<std::size_t>(cell.agreement) == k; });
        std::string name(sweep::agreement_names[k]);
        std::replace(name.begin(), name.end(), '_', ' ');
        if (number > 0) text += fmt::format(" {} {} ", name, number);
    }
    return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
}

std::string outside_text(const sweep::Study& study) {
    std::string values;
    for (const sweep::Axis* axis : {&study.x, &study.y}) {
        if (axis == &study.y && sweep::has_one_axis(study)) continue;
        values += (values.empty() ? "" : ", ") + axis->parameter + " = " +
                  parameters::value_text(study.base, axis->parameter);
    }
    return "the design lies outside of the chart: " + values;
}

std::string cells_text(const sweep::SweepResult& result) {
    sweep::Counts counts;
    for (const sweep::CellVerdict& cell : result.cells)
        sweep::count(counts, cell);
    const std::string share =
        result.study.refine == 0 ? "" : fmt::format(", {} of them computed", sweep::computed_count(result));
    return fmt::format("{} cells{}: {}\n", result.cells.size(), share, counts_text(counts));
}

std::string failures_text(const sweep::SweepResult& result, const std::string& chart_file) {
    std::size_t failures = 0;
    std::size_t first = result.cells.size();
    for (std::size_t k = 0; k < result.cells.size(); ++k) {
        if (result.cells[k].status == sweep::Status::done) continue;
        // an inferred cell has no message of its own
        if (first == result.cells.size() && !sweep::is_inferred(result, k)) first = k;
        ++failures;
    }
    if (failures == 0) return {};
    return fmt::format("{} of {} cells have no result and are drawn hatched; the first: {} ({})\n  reproduce: {}",
                       failures, result.cells.size(),
                       sweep::status_names[static_cast<std::size_t>(result.cells[first].status)],
                       sweep::computed_cell(result, first).message,
                       sweep::reproduce_command(result.study, sweep::shown_place(result, first), chart_file));
}

}  // namespace stridor::console
