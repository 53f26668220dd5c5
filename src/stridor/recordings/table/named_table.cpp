#include "stridor/recordings/table/named_table.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::recordings {

namespace {

std::size_t size_of_mark(const Bytes& bytes) {
    return text_at(bytes, 0, csv_table::utf8_mark.size()) == csv_table::utf8_mark ? csv_table::utf8_mark.size() : 0;
}

}  // namespace

NamedTable::NamedTable(const std::shared_ptr<const Bytes>& bytes, std::string file)
    : lines_(bytes, std::move(file), size_of_mark(*bytes)) {
    if (csv_table::utf16_in(text_at(*bytes, 0, 4096)))
        throw refusal(lines_.name(), "the table is in UTF-16", "", "Save it as UTF-8.");
    const std::optional<TextLine> line = next_line();
    if (!line) throw refusal(lines_.name(), "the table is empty", "its first row names its columns");
    dialect_ = csv_table::sniff(line->text);
    std::vector<csv_table::CsvField> titles = csv_table::split(line->text, dialect_.delimiter);
    csv_table::drop_empty_tail(titles, 1);
    for (const csv_table::CsvField& field : titles) {
        csv_table::Title title = csv_table::title_of(field.text);
        base::Place place = place_of(lines_.name(), *line, field.column);
        if (!title.name.empty() && has(csv_table::lower(title.name)))
            throw refusal(std::move(place), "two columns are called \"" + title.name + "\"");
        columns_.push_back({csv_table::lower(title.name), std::move(title.unit), std::move(place)});
    }
}

std::optional<TextLine> NamedTable::next_line() {
    std::optional<TextLine> line = lines_.next();
    while (line && (base::trimmed(line->text).empty() || line->text.starts_with('#')))
        line = lines_.next();
    return line;
}

bool NamedTable::next() {
    const std::optional<TextLine> line = next_line();
    if (!line) return false;
    row_ = *line;
    fields_ = csv_table::split(line->text, dialect_.delimiter);
    csv_table::drop_empty_tail(fields_, columns_.size());
    if (fields_.size() > columns_.size())
        throw refusal(
            place_of(lines_.name(), *line, fields_[columns_.size()].column),
            "the row has " + std::to_string(fields_.size()) + " fields",
            "the first row names " + std::to_string(columns_.size()) + " columns",
            dialect_.delimiter == ',' ? "Write a decimal mark as a point, and a text with commas in quotes." : "");
    return true;
}

std::optional<std::size_t> NamedTable::find(std::string_view name) const {
    const auto found =
        std::find_if(columns_.begin(), columns_.end(), [&](const NamedColumn& column) { return column.name == name; });
    if (found == columns_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - columns_.begin());
}

std::string NamedTable::text(std::string_view name) const {
    const std::optional<std::size_t> column = find(name);
    return column && *column < fields_.size() ? fields_[*column].text : std::string();
}

std::optional<double> NamedTable::number(std::string_view name) const {
    const std::optional<double> value = csv_table::number_in(text(name), dialect_);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace stridor::recordings
