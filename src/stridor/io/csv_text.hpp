#pragma once

// What all CSV texts share. Private to this folder.

#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::io::csv_text {

inline constexpr std::string_view no_unit = "-";  // of a column of words

struct Column {
    std::string name;
    std::string unit;
};

// RFC 4180; a leading # is quoted too, so that it is not taken for a comment, and no text is taken for a formula
inline std::string quoted(std::string_view words) {
    const std::string text = base::spreadsheet_text(words);
    const bool is_plain = text.find_first_of(",\"\r\n#") == std::string_view::npos;
    if (is_plain) return text;
    std::string result = "\"";
    for (const char c : text)
        result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

/// Rows of fields.
class Table {
public:
    explicit Table(std::string opening) : text_(std::move(opening)) {}

    void word(std::string_view word) { field(quoted(word)); }
    void number(double value) { field(std::isnan(value) ? std::string() : base::shortest(value)); }
    void end_row() {
        text_ += '\n';
        is_first_ = true;
    }

    void header(const std::vector<Column>& columns) {
        for (const Column& column : columns)
            word(column.name);
        end_row();
        for (const Column& column : columns)
            word(column.unit);
        end_row();
    }

    /// What was written since it was taken last.
    std::string take() { return std::exchange(text_, {}); }

private:
    void field(const std::string& text) {
        if (!is_first_) text_ += ',';
        text_ += text;
        is_first_ = false;
    }

    std::string text_;
    bool is_first_ = true;
};

inline std::string comment(std::string_view key, std::string_view value) {
    std::string line = "# " + std::string(key) + ": " + std::string(value);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return base::spreadsheet_line(line) + "\n";
}

}  // namespace stridor::io::csv_text
