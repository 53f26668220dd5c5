#include "stridor/console/results/text_table.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace stridor::console {

namespace {

std::vector<std::size_t> widths_of(const TextTable& table) {
    std::vector<std::size_t> widths;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        const TextColumn& column = table.columns[k];
        widths.push_back(column.width > 0 ? column.width : width_of(column.heading));
        for (const std::vector<std::string>& row : table.rows)
            if (column.width == 0 && k < row.size()) widths[k] = std::max(widths[k], width_of(row[k]));
    }
    return widths;
}

}  // namespace

TextColumn left(std::string_view heading, std::size_t width) {
    return {std::string(heading), width, TextColumn::Side::left};
}

TextColumn right(std::string_view heading, std::size_t width) {
    return {std::string(heading), width, TextColumn::Side::right};
}

std::string text_of(const TextTable& table) {
    const std::vector<std::size_t> widths = widths_of(table);
    const auto line = [&](const std::vector<std::string>& cells) {
        std::string text(table.indent);
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const TextColumn& column = table.columns[k];
            const std::string blanks(widths[k] - std::min(widths[k], width_of(cells[k])), ' ');
            if (column.width == 0 && k > 0) text += "  ";
            text += column.side == TextColumn::Side::left ? cells[k] + blanks : blanks + cells[k];
        }
        return text.erase(text.find_last_not_of(' ') + 1);
    };
    std::vector<std::string> headings;
    for (const TextColumn& column : table.columns)
        headings.push_back(column.heading);
    std::string text;
    if (const std::string first = line(headings); !first.empty())
        text = styled(first, table.heading, STDOUT_FILENO) + "\n";
    for (const std::vector<std::string>& row : table.rows)
        text += line(row) + "\n";
    return text;
}

std::size_t width_of(std::string_view text) {
    std::size_t codes = 0;
    for (std::size_t at = text.find("\033["); at != std::string_view::npos; at = text.find("\033[", at + 1))
        if (const std::size_t end = text.substr(at, 8).find('m'); end != std::string_view::npos) codes += end + 1;
    // padded to as many columns as it has bytes, which are never fewer, it shows how many it lacks
    return 2 * text.size() - fmt::formatted_size("{:<{}}", text, text.size()) - codes;
}

std::string number_or_dash(double value, const char* format) {
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

std::string after_number(std::string_view unit) {
    return unit.empty() || unit == "1" ? "" : " " + std::string(unit);
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string margin_lines(std::span<const classification::Margin> margins, std::size_t figure, std::size_t threshold) {
    std::string text;
    for (const classification::Margin& margin : margins) {
        if (!std::isfinite(margin.figure)) continue;
        const bool has_error = margin.error && *margin.error > 0.0;
        text += styled(
            fmt::format("    {:<{}} {:>9.4g}  threshold {:<{}} {:>7.4g}  distance {:+.4g}{}\n", margin.figure_name,
                        figure, margin.figure, margin.threshold_name, threshold, margin.threshold, margin.distance,
                        has_error ? fmt::format("  error {:.1g}", *margin.error) : ""),
            Style::dim, STDOUT_FILENO);
    }
    return text;
}

}  // namespace stridor::console
