#include "stridor/console/results/sensitivity_text.hpp"

#include "stridor/console/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace stridor::console {

namespace {

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
