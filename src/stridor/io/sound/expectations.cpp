#include "stridor/io/sound/expectations.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/table/csv_table.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <optional>
#include <sstream>

namespace stridor::io {

namespace {

using classification::Category;
using hearing::Expectation;
using Row = std::vector<std::string>;
using RowPlace = base::Place;

constexpr int most_files = 1000;  // of one row

[[noreturn]] void refuse(const RowPlace& place, std::string what, std::string why, std::string suggestion) {
    throw Error(ErrorKind::input, {std::move(what), std::move(why), std::move(suggestion)}, place);
}

// "| a | b |" -> {"a", "b"}; empty for any other line
Row markdown_row(std::string_view line) {
    line = base::trimmed(line);
    if (line.size() < 2 || line.front() != '|') return {};
    line.remove_prefix(1);
    if (line.back() == '|') line.remove_suffix(1);
    Row row;
    for (std::string_view rest = line;;) {
        const std::size_t bar = rest.find('|');
        row.emplace_back(base::trimmed(rest.substr(0, bar)));
        if (bar == std::string_view::npos) return row;
        rest.remove_prefix(bar + 1);
    }
}

Row csv_row(std::string_view line, char delimiter) {
    Row row;
    if (base::trimmed(line).empty() || line.front() == '#') return row;
    for (const recordings::csv_table::CsvField& field : recordings::csv_table::split(line, delimiter))
        row.push_back(field.text);
    return row;
}

bool is_rule(const Row& row) {
    return row.front().find_first_not_of("-: ") == std::string::npos;
}

std::vector<Category> categories_in(const std::string& words) {
    std::vector<Category> found;
    std::string spaced = words.substr(0, words.find(','));
    std::replace(spaced.begin(), spaced.end(), '|', ' ');
    std::istringstream text(spaced);
    for (std::string word; text >> word;) {
        if (word == "or") continue;
        const auto known =
            std::find(classification::category_names.begin(), classification::category_names.end(), word);
        if (known == classification::category_names.end() || word == classification::name(Category::undecided))
            return {};
        found.push_back(static_cast<Category>(known - classification::category_names.begin()));
    }
    return found;
}

// "scrape_01 .. 04.ogg" -> scrape_01.ogg, scrape_02.ogg, ...
std::vector<std::string> names_in(const std::string& text) {
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos) return {text};
    const std::string first(base::trimmed(text.substr(0, dots)));
    const std::string rest(base::trimmed(text.substr(dots + 2)));
    const std::size_t digits = rest.find_first_not_of("0123456789");
    if (digits == 0 || digits == std::string::npos || first.size() <= digits) return {text};
    const std::string stem = first.substr(0, first.size() - digits);
    const auto number = [&](const std::string& part) {
        int value = -1;
        const auto [end, code] = std::from_chars(part.data(), part.data() + digits, value);
        return code == std::errc{} && end == part.data() + digits ? value : -1;
    };
    const int from = number(first.substr(stem.size()));
    const int to = number(rest);
    if (from < 0 || to < from || to - from >= most_files) return {text};
    std::vector<std::string> names;
    for (int k = from; k <= to; ++k) {
        const std::string shown = std::to_string(k);
        names.push_back(stem + std::string(digits - std::min(digits, shown.size()), '0') + shown + rest.substr(digits));
    }
    return names;
}

struct ExpectationTable {
    std::filesystem::path path;
    bool is_csv = false;
};

// where a row has what; the number of its fields where it has it not
struct Columns {
    std::size_t file = 0;
    std::size_t expected = 0;
    std::size_t source = 0;
    std::size_t confidence = 0;
};

std::optional<Columns> columns_of(const Row& header) {
    const auto column = [&](std::string_view name) {
        return static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
    };
    const Columns columns{column("file"), column("expected"), std::min(column("source"), column("repository")),
                          column("confidence")};
    if (std::max(columns.file, columns.expected) == header.size()) return std::nullopt;
    return columns;
}

// the file in the folder; a table that lies elsewhere may name it by a path of its own
std::filesystem::path place_of(const std::filesystem::path& folder, const std::string& name) {
    std::error_code ignored;
    const std::filesystem::path whole = folder / name;
    const std::filesystem::path last = folder / std::filesystem::path(name).filename();
    return !std::filesystem::is_regular_file(whole, ignored) && std::filesystem::is_regular_file(last, ignored) ? last
                                                                                                                : whole;
}

void add(const Row& row, const Columns& columns, const RowPlace& place, const std::filesystem::path& folder,
         std::vector<Expectation>& expectations) {
    if (row.size() <= std::max(columns.file, columns.expected))
        refuse(place, "the row has no field for each column", "file and expected category are needed", "");
    const std::vector<Category> categories = categories_in(row[columns.expected]);
    if (categories.empty())
        refuse(place, "\"" + row[columns.expected] + "\" names no category",
               "expected is none, squeal, squeak or creak, or several joined by \"or\"", "");
    const std::string source = columns.source < row.size() ? row[columns.source] : "";
    const bool is_sure = columns.confidence >= row.size() || row[columns.confidence] != "low";
    for (const std::string& name : names_in(row[columns.file])) {
        const std::filesystem::path path = place_of(folder, name);
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(path, ignored))
            refuse(place, path.string() + " is not there", "the table names it", "");
        expectations.push_back({path.string(), row[columns.expected], categories, source, is_sure});
    }
}

std::vector<Expectation> read_table(const ExpectationTable& table, const std::filesystem::path& folder) {
    const std::string text = storage::read_file(table.path.string());
    std::istringstream lines(text);
    std::vector<Expectation> expectations;
    std::optional<Columns> columns;
    char delimiter = ',';
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (number == 1 && line.starts_with(recordings::csv_table::utf8_mark))
            line.erase(0, recordings::csv_table::utf8_mark.size());
        if (table.is_csv && !columns) delimiter = recordings::csv_table::sniff(line).delimiter;
        const Row row = table.is_csv ? csv_row(line, delimiter) : markdown_row(line);
        if (row.empty() && columns && !table.is_csv) break;  // the table's end
        if (row.empty()) continue;
        const RowPlace place{table.path.string(), number, 1, line};
        if (!columns) {
            columns = columns_of(row);
            if (!columns && table.is_csv)
                refuse(place, "the first row names no columns \"file\" and \"expected\"", "a row must say what is what",
                       "Begin with: file,expected");
        } else if (!is_rule(row)) {
            add(row, *columns, place, folder, expectations);
        }
    }
    return expectations;
}

}  // namespace

std::vector<Expectation> read_expectations(const std::string& folder, const std::string& labels) {
    const std::filesystem::path path(folder);
    std::error_code ignored;
    if (!std::filesystem::is_directory(path, ignored))
        throw Error(ErrorKind::input, {folder + " is no folder", "recordings stand in one", ""});
    if (!labels.empty()) {
        std::vector<Expectation> found = read_table({labels, !labels.ends_with(".md")}, path);
        if (!found.empty()) return found;
        throw Error(ErrorKind::input, {labels + " labels no recording", "it has no rows", ""});
    }
    const ExpectationTable csv{path / "expected.csv", true};
    const ExpectationTable page{path / "README.md", false};
    for (const ExpectationTable& table : {csv, page}) {
        if (!std::filesystem::is_regular_file(table.path, ignored)) continue;
        std::vector<Expectation> found = read_table(table, path);
        if (!found.empty()) return found;
    }
    throw Error(ErrorKind::input, {folder + " has no table of what its recordings are",
                                   "neither expected.csv nor README.md has columns file and expected with rows",
                                   "Write expected.csv with a first row file,expected and a row per recording."});
}

}  // namespace stridor::io
