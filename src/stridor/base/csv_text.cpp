#include "stridor/base/csv_text.hpp"

#include "stridor/base/escapes.hpp"
#include "stridor/base/version.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace stridor::base::csv_text {

namespace {

// as part of a line that spreadsheets part at commas: an odd quote would join it with the next lines
std::string plain(std::string text) {
    for (char& c : text) {
        if (c == '\n' || c == '\r') c = ' ';
        if (c == '"') c = '\'';
        if (c == '|') c = '/';
    }
    return text;
}

std::string heading(const TableColumn& column) {
    const bool has_unit = !column.unit.empty() && column.unit != "1";
    return has_unit ? column.name + " [" + column.unit + "]" : column.name;
}

}  // namespace

Facts origin(std::string_view what) {
    return {{"schema", "stridor." + std::string(what) + "/1"},
            {"version", std::string(base::version())},
            {"commit", std::string(base::commit())}};
}

std::string first_line(const Facts& facts) {
    std::string line = "#";
    for (const auto& [key, value] : facts)
        line += std::string(line == "#" ? " " : fact_mark) + plain(key) + ": " + plain(value);
    return base::spreadsheet_line(line) + "\n";
}

std::string quoted(std::string_view words) {
    const std::string text = base::spreadsheet_text(words);
    const bool is_plain = text.find_first_of(",;\t\"\r\n#") == std::string_view::npos;
    if (is_plain) return text;
    std::string result = "\"";
    for (const char c : text)
        result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

Table::Table(const Facts& facts, const std::vector<TableColumn>& columns) : text_(first_line(facts)) {
    for (const TableColumn& column : columns)
        word(heading(column));
    end_row();
}

void Table::number(double value) {
    std::array<char, 32> buffer{};
    const char* end =
        std::isnan(value) ? buffer.data() : std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    field({buffer.data(), static_cast<std::size_t>(end - buffer.data())});
}

void Table::end_row() {
    text_ += '\n';
    is_first_ = true;
}

void Table::field(std::string_view text) {
    if (!is_first_) text_ += ',';
    text_ += text;
    is_first_ = false;
}

}  // namespace stridor::base::csv_text
