#include "stridor/io/sound/expectations.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/table/named_table.hpp"
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

// what a row of a table says
struct ExpectedRow {
    std::string file;
    std::string expected;
    std::string source;
    std::string confidence;
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

void add(const ExpectedRow& row, const RowPlace& place, const std::filesystem::path& folder,
         std::vector<Expectation>& expectations) {
    if (row.file.empty() || row.expected.empty())
        refuse(place, "the row has no field for each column", "file and expected category are needed", "");
    const std::vector<Category> categories = categories_in(row.expected);
    if (categories.empty())
        refuse(place, "\"" + row.expected + "\" names no category",
               "expected is none, squeal, squeak or creak, or several joined by \"or\"", "");
    for (const std::string& name : names_in(row.file)) {
        const std::filesystem::path path = place_of(folder, name);
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(path, ignored))
            refuse(place, path.string() + " is not there", "the table names it", "");
        expectations.push_back({path.string(), row.expected, categories, row.source, row.confidence != "low"});
    }
}

std::vector<Expectation> read_csv(const std::filesystem::path& path, const std::filesystem::path& folder) {
    recordings::NamedTable table(recordings::open_plain_bytes(path.string()), path.string());
    if (!table.has("file") || !table.has("expected"))
        refuse(table.columns().front().place, "the first row names no columns \"file\" and \"expected\"",
               "a row must say what is what", "Begin with: file,expected");
    const std::string source = table.has("source") ? "source" : "repository";
    std::vector<Expectation> expectations;
    while (table.next())
        add({table.text("file"), table.text("expected"), table.text(source), table.text("confidence")}, table.place(),
            folder, expectations);
    return expectations;
}

// the first table of a page that has the columns
std::vector<Expectation> read_page(const std::filesystem::path& path, const std::filesystem::path& folder) {
    std::istringstream lines(storage::read_file(path.string()));
    std::vector<Expectation> expectations;
    std::optional<Columns> columns;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const Row row = markdown_row(line);
        if (row.empty() && columns) break;  // the table's end
        if (row.empty() || is_rule(row)) continue;
        const auto field = [&](std::size_t column) { return column < row.size() ? row[column] : std::string(); };
        if (!columns)
            columns = columns_of(row);
        else
            add({field(columns->file), field(columns->expected), field(columns->source), field(columns->confidence)},
                {path.string(), number, 1, line}, folder, expectations);
    }
    return expectations;
}

std::vector<Expectation> read_table(const std::filesystem::path& table, const std::filesystem::path& folder) {
    return table.extension() == ".md" ? read_page(table, folder) : read_csv(table, folder);
}

}  // namespace

std::vector<Expectation> read_expectations(const std::string& folder, const std::string& labels) {
    const std::filesystem::path path(folder);
    std::error_code ignored;
    if (!std::filesystem::is_directory(path, ignored))
        throw Error(ErrorKind::input, {folder + " is no folder", "recordings stand in one", ""});
    if (!labels.empty()) {
        std::vector<Expectation> found = read_table(labels, path);
        if (!found.empty()) return found;
        throw Error(ErrorKind::input, {labels + " labels no recording", "it has no rows", ""});
    }
    for (const char* name : {"expected.csv", "README.md"}) {
        if (!std::filesystem::is_regular_file(path / name, ignored)) continue;
        std::vector<Expectation> found = read_table(path / name, path);
        if (!found.empty()) return found;
    }
    throw Error(ErrorKind::input, {folder + " has no table of what its recordings are",
                                   "neither expected.csv nor README.md has columns file and expected with rows",
                                   "Write expected.csv with a first row file,expected and a row per recording."});
}

}  // namespace stridor::io
