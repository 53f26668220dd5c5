#include "stridor/console/results/rig_text.hpp"

#include "stridor/console/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
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

using noise_library::Bin;
using noise_library::CategoryRange;
using noise_library::RankCorrelation;
using noise_library::Sensitivity;

std::string with_unit(const std::string& unit) {
    return unit.empty() || unit == "1" ? "" : " " + unit;
}

std::string number(double value, const char* missing = "-") {
    return std::isnan(value) ? missing : fmt::format("{:.5g}", value);
}

std::string name_of(const std::string& category) {
    return category.empty() ? "unknown" : category;
}

std::string range_text(const Bin& bin) {
    return bin.from == bin.to ? number(bin.from) : number(bin.from) + " to " + number(bin.to);
}

// letters of a range of `Bin`s, wide enough for them all
std::size_t widest(const Sensitivity& result) {
    std::size_t width = result.quantity.size();
    for (const Bin& bin : result.bins)
        width = std::max(width, range_text(bin).size());
    return width;
}

std::string bins_table(const Sensitivity& result) {
    const std::size_t width = widest(result);
    const std::size_t level_width = std::max<std::size_t>(10, result.level_unit.size());
    const auto line = [&](const std::string& range, const std::string& records, const std::string& level,
                          const std::string& frequency) {
        return fmt::format("{:>{}}  {:>7}  {:>{}}  {:>10}", range, width, records, level, level_width, frequency);
    };
    std::string names = line(result.quantity, "records", "level", "frequency");
    std::string units = line(result.unit == "1" ? "" : result.unit, "", result.level_unit, "Hz");
    for (const CategoryRange& category : result.categories)
        names += "  " + name_of(category.category);
    std::string text = styled(names, Style::bold, STDOUT_FILENO) + "\n" + units + "\n";
    for (const Bin& bin : result.bins) {
        text += line(range_text(bin), std::to_string(bin.records), number(bin.level), number(bin.frequency));
        for (const CategoryRange& category : result.categories) {
            const auto found = std::find_if(bin.categories.begin(), bin.categories.end(),
                                            [&](const auto& count) { return count.category == category.category; });
            text += fmt::format("  {:>{}}", found == bin.categories.end() ? "-" : std::to_string(found->records),
                                name_of(category.category).size());
        }
        text += "\n";
    }
    return text;
}

std::string categories_table(const Sensitivity& result) {
    std::string text;
    for (const CategoryRange& category : result.categories)
        text += fmt::format("{:<12} {} {}, {} {} to {}{}, median {}\n", name_of(category.category), category.records,
                            category.records == 1 ? "record" : "records", result.quantity, number(category.lowest),
                            number(category.highest), with_unit(result.unit), number(category.median));
    return text;
}

std::string correlation_line(const char* what, const RankCorrelation& correlation) {
    if (std::isnan(correlation.coefficient))
        return fmt::format("{:<20} no rank correlation: {}\n", what,
                           correlation.records < 3
                               ? fmt::format("{} of at least 3 records have both", correlation.records)
                               : "all values are equal");
    return fmt::format("{:<20} rank correlation {:+.3f} (Spearman, n = {}, p = {:.2g})\n", what,
                       correlation.coefficient, correlation.records, correlation.p_value);
}

std::string records_table(const Sensitivity& result) {
    const std::size_t width = std::max<std::size_t>(10, result.level_unit.size());
    const auto line = [&](const std::string& id, const std::string& quantity, const std::string& category,
                          const std::string& level, const std::string& frequency) {
        return fmt::format("{:>6}  {:>12}  {:<12}  {:>{}}  {:>10}\n", id, quantity, category, level, width, frequency);
    };
    std::string text = line("id", result.quantity, "category", "level", "frequency");
    text += line("", result.unit == "1" ? "" : result.unit, "", result.level_unit, "Hz");
    for (const noise_library::Observation& record : result.records)
        text += line(std::to_string(record.id), number(record.quantity), name_of(record.category), number(record.level),
                     number(record.frequency));
    return text;
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

std::string sensitivity_text(const Sensitivity& result, SensitivityRows rows) {
    std::string text = rows == SensitivityRows::records ? records_table(result) : bins_table(result);
    text += "\n" + categories_table(result) + "\n";
    text += correlation_line("level", result.level) + correlation_line("dominant frequency", result.frequency);
    if (result.left_out > 0)
        text += fmt::format("left out: {} {} without a {}\n", result.left_out,
                            result.left_out == 1 ? "record" : "records", result.quantity);
    return text;
}

}  // namespace stridor::console
