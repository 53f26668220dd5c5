#include "stridor/console/results/stability_text.hpp"

#include "stridor/console/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace stridor::console {

namespace {

using analysis::StabilityKind;

std::string kind_name(StabilityKind kind) {
    return std::string(analysis::stability_names[static_cast<std::size_t>(kind)]);
}

std::string modes_text(const analysis::SlidingStability& stability) {
    std::string text;
    for (const analysis::Eigenmode& mode : stability.modes)
        text += fmt::format("  {:9.2f} Hz {:+10.3f} 1/s", mode.frequency, mode.growth);
    return text;
}

std::string header(const analysis::StabilityScan& scan) {
    std::string text = styled("stability of steady sliding", Style::bold, STDOUT_FILENO) + "\n\n";
    for (const analysis::DirectionScan& direction : scan.directions) {
        const analysis::SlidingStability& here = direction.here;
        text += fmt::format("{:<8}{:<11}N/F {:8.4f}  modes{}\n",
                            parameters::direction_names[static_cast<std::size_t>(direction.direction)],
                            kind_name(here.kind), here.normal_force / scan.base.contact.preload, modes_text(here));
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
                            kind_name(boundary.above), scan.key, boundary.value,
                            scan.unit == "1" ? "" : " " + scan.unit, boundary.frequency);
    return text;
}

}  // namespace

std::string stability_text(const analysis::StabilityScan& scan) {
    std::string text = header(scan);
    if (scan.key.empty()) return text;
    text += "\n";
    for (const analysis::DirectionScan& direction : scan.directions)
        text += boundary_lines(scan, direction);
    const std::string name = scan.key.substr(scan.key.find('.') + 1);
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

}  // namespace stridor::console
