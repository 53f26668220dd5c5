#include "stridor/console/results/friction_text.hpp"

#include "stridor/console/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

namespace stridor::console {

namespace {

using analysis::FrictionFigures;
using analysis::FrictionTrace;

std::string number_or_dash(double value, const char* unit) {
    return std::isfinite(value) ? fmt::format("{:.4g}{}", value, unit) : "-";
}

std::string row(const FrictionFigures& figures) {
    const char* direction = figures.direction == 0 ? "all" : figures.direction > 0 ? "going" : "coming";
    return fmt::format("{:<8}{:>18}{:>18}{:>9.4f}{:>7}{:>11}{:>11}{:>11}{:>11}\n", direction,
                       coefficient_text(figures.static_friction), coefficient_text(figures.kinetic_friction),
                       figures.mean_friction, figures.drops, number_or_dash(figures.drop_rate, " 1/s"),
                       number_or_dash(figures.mean_drop, " N"), number_or_dash(figures.largest_drop, " N"),
                       number_or_dash(figures.variation, ""));
}

}  // namespace

std::string coefficient_text(const analysis::MeasuredCoefficient& c) {
    if (!std::isfinite(c.value)) return "-";
    return std::isfinite(c.uncertainty) && c.count > 1 ? fmt::format("{:.4f} +- {:.4f}", c.value, c.uncertainty)
                                                       : fmt::format("{:.4f}", c.value);
}

std::string friction_text(const io::FrictionTest& test, const FrictionTrace& trace) {
    std::string text = styled(test.file, Style::bold, STDOUT_FILENO) + "\n";
    text += fmt::format("{:.4g} s at {:g} Hz, preload {:g} N", test.duration, test.rate, test.preload);
    if (std::isfinite(test.velocity)) text += fmt::format(", {:.4g} mm/s", 1e3 * test.velocity);
    if (!test.condition.empty()) text += " (" + test.condition + ")";
    text += fmt::format(
        "\nforce \"{}\"{}{}; noise {:.2g} N, drops from {:.3g} N on\n\n", test.channel,
        test.velocity_channel.empty() ? ", direction by its sign" : ", velocity \"" + test.velocity_channel + "\"",
        test.normal_channel.empty() ? "" : ", normal force \"" + test.normal_channel + "\"", trace.noise,
        trace.threshold * test.preload);
    text += fmt::format("{:<8}{:>18}{:>18}{:>9}{:>7}{:>11}{:>11}{:>11}{:>11}\n", "", "static", "kinetic", "mean",
                        "drops", "rate", "mean drop", "largest", "variation");
    for (const FrictionFigures& figures : trace.directions)
        text += row(figures);
    if (trace.directions.size() > 1) text += row(trace.all);
    text +=
        fmt::format("\nkinetic from {}", analysis::kinetic_source_names[static_cast<std::size_t>(trace.all.source)]);
    if (trace.all.drops > 0 && std::isfinite(trace.all.distance))
        text += fmt::format("; {:.4g} drops per millimetre",
                            static_cast<double>(trace.all.drops) / (1e3 * trace.all.distance));
    return text + "; +- is one standard uncertainty\n";
}

}  // namespace stridor::console
