#include "stridor/io/case/toml_document.hpp"

#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/case/complaints.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field_name.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "stridor/recordings/recording_files.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <sstream>
#include <tuple>
#include <utility>

namespace stridor::io {

namespace {

// Bounds on what is handed to the parser. A case file has some 3 KiB; the resolved one of a part of 500 rows has its
// matrices with 16 MiB. Without bounds a file of nothing but "a.a.a..." nests so deeply that taking it down overflows
// the stack.
constexpr std::size_t largest_file = 16U << 20U;  // [1] bytes
constexpr std::ptrdiff_t most_points = 4000;      // [1] "." in names, each of which may open a section
constexpr std::ptrdiff_t deepest_text = 64;       // [1] levels of lists, tables and dotted names; keys have three

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        if (line.ends_with('\r')) line.pop_back();
        lines.push_back(std::move(line));
    }
    return lines;
}

/// Turns the parser's positions into places.
class Places {
public:
    Places(const std::string& text, std::string name) : lines_(lines_of(text)), name_(std::move(name)) {}

    base::Place at(const toml::source_position& position) const {
        const std::size_t line = position.line;
        const bool is_known = line >= 1 && line <= lines_.size();
        return {name_, static_cast<int>(line), static_cast<int>(position.column),
                is_known ? lines_[line - 1] : std::string()};
    }

private:
    std::vector<std::string> lines_;
    std::string name_;
};

// "Error while parsing key-value pair: expected value, saw ..." without its first half
std::string essence(std::string_view description) {
    constexpr std::string_view opening = "Error while parsing ";
    const std::size_t colon = description.find(": ");
    if (description.starts_with(opening) && colon != std::string_view::npos) description.remove_prefix(colon + 2);
    return std::string(description);
}

std::string between_quotes(std::string_view text) {
    const std::size_t first = text.find('\'');
    const std::size_t last = text.rfind('\'');
    if (first == std::string_view::npos || last <= first) return {};
    return std::string(text.substr(first + 1, last - first - 1));
}

Error duplicate_error(const std::string& message, base::Place place) {
    const std::string name = between_quotes(message.substr(0, message.find(" as ")));
    // the parser stops behind the key; the reader wants to see the key itself
    const std::size_t start = place.source_line.find_first_not_of(" \t");
    const bool is_section = start != std::string::npos && place.source_line[start] == '[';
    const std::size_t found = place.source_line.find(name, start == std::string::npos ? 0 : start);
    if (!name.empty() && found != std::string::npos && !is_section) place.column = static_cast<int>(found) + 1;
    const std::string what = is_section     ? "duplicate section [" + name + "]"
                             : name.empty() ? std::string("duplicate key")
                                            : "duplicate key " + name;
    return {ErrorKind::input, {what, "it is set once already", "Remove one of the two."}, std::move(place)};
}

constexpr const char* other_encoding = "one of its bytes is of another encoding, such as Latin-1";

std::string advice(const std::string& message) {
    if (message.find("saw ','") != std::string::npos) return "Numbers are written with a point: 0.5, not 0,5.";
    if (message.find("expected a comment or whitespace") != std::string::npos)
        return "Put a value with a unit in quotes: \"20 N\".";
    if (message.find("could not determine value type") != std::string::npos) return "Put text in quotes.";
    return {};
}

Error parse_error(const toml::parse_error& error, const Places& places) {
    const std::string message = essence(error.description());
    base::Place place = places.at(error.source().begin);
    if (message.find("cannot redefine") != std::string::npos) return duplicate_error(message, std::move(place));
    if (message.find("invalid utf-8") != std::string::npos)
        return {
            ErrorKind::input, {"the file is not UTF-8 text", other_encoding, "Save it as UTF-8."}, std::move(place)};
    return {ErrorKind::input, {message, "the file is not valid TOML", advice(message)}, std::move(place)};
}

// The parser stops at the first error. A line that says no more than "key = value" may be left out to find the next
// one; without any other line what follows would be taken for something else.
bool leave_out_line(std::string& text, std::size_t line) {
    std::size_t from = 0;
    for (std::size_t k = 1; k < line; ++k) {
        from = text.find('\n', from);
        if (from++ == std::string::npos) return false;
    }
    const auto count = [&](char c) {
        return std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(from), c);
    };
    if (count('[') != count(']') || count('{') != count('}')) return false;  // it may stand in a list
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string_view whole = base::trimmed(std::string_view(text).substr(from, end - from));
    const bool is_setting =
        !whole.empty() && whole.front() != '[' && whole.front() != '#' && whole.find('=') != std::string_view::npos &&
        whole.find_first_of("[]{}") == std::string_view::npos && whole.find("\"\"\"") == std::string_view::npos &&
        whole.find("'''") == std::string_view::npos;
    if (is_setting) text[from] = '#';
    return is_setting;
}

toml::table parsed(const std::string& text, const Places& places) {
    constexpr int most_errors = 50;
    Complaints complaints;
    std::string remaining = text;
    for (int k = 0; k < most_errors; ++k)
        try {
            toml::table table = toml::parse(std::string_view(remaining));
            complaints.throw_any();
            return table;
        } catch (const toml::parse_error& error) {
            complaints.add(parse_error(error, places));
            if (!leave_out_line(remaining, error.source().begin.line)) break;
        }
    complaints.throw_any();
    return {};
}

std::optional<std::vector<double>> numbers_in(const toml::array& array) {
    std::vector<double> numbers;
    for (const toml::node& element : array) {
        const auto number = element.is_number() ? element.value<double>() : std::nullopt;
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

// [[2, -1], [-1, 2]]
std::optional<TomlRows> rows_in(const toml::array& array) {
    TomlRows rows;
    for (const toml::node& element : array) {
        const auto row = element.is_array() ? numbers_in(*element.as_array()) : std::nullopt;
        if (!row) return std::nullopt;
        rows.push_back(*row);
    }
    return rows;
}

TomlValue array_value(const toml::array& array) {
    if (!array.empty() && array.front().is_array())
        if (auto rows = rows_in(array)) return std::move(*rows);
    std::vector<std::string> texts;
    std::vector<double> numbers;
    for (const toml::node& element : array) {
        if (const auto text = element.value_exact<std::string>())
            texts.push_back(*text);
        else if (const auto number = element.value<double>(); number && element.is_number())
            numbers.push_back(*number);
        else
            return TomlUnfit{"a list of other things than text or numbers"};
    }
    if (numbers.empty()) return texts;
    if (texts.empty()) return numbers;
    return TomlUnfit{"a list of text and numbers"};
}

TomlValue value_of(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::integer:
            return static_cast<double>(node.as_integer()->get());
        case toml::node_type::floating_point:
            return node.as_floating_point()->get();
        case toml::node_type::string:
            return node.as_string()->get();
        case toml::node_type::array:
            return array_value(*node.as_array());
        case toml::node_type::table:
            return TomlTable{};
        case toml::node_type::boolean:
            return TomlUnfit{"a boolean"};
        default:
            return TomlUnfit{"a date or time"};
    }
}

// Keys are five names long at most ("temperature.joint.lip2.contact.kinetic_friction"); what lies deeper hangs on a key
// that is unknown already.
constexpr int deepest = 5;
// what may be there several times: [[joint]], [[structure.contact]], [[structure.output]], [[structure.spring]], and
// [[pair]] of another file
constexpr std::array<std::string_view, 5> listed_sections{"joint", "structure.contact", "structure.output",
                                                          "structure.spring", "pair"};

bool is_list_of_tables(const toml::node& node) {
    const toml::array* list = node.as_array();
    return list != nullptr && list->is_array_of_tables();
}

void collect(const toml::table& table, const std::string& prefix, int depth, const Places& places,
             std::vector<TomlEntry>& entries) {
    for (const auto& [key, node] : table) {
        const std::string full = prefix + std::string(key.str());
        // [[joint]]: its tables are called by their numbers, "joint.1"
        const bool may_be_listed =
            std::find(listed_sections.begin(), listed_sections.end(), full) != listed_sections.end();
        if (may_be_listed && is_list_of_tables(node)) {
            const toml::array& list = *node.as_array();
            entries.push_back(
                {full, TomlTable{}, TomlOrigin::file, places.at(key.source().begin), places.at(node.source().begin)});
            for (std::size_t k = 0; k < list.size(); ++k) {
                const toml::table& each = *list[k].as_table();
                const std::string name = full + "." + std::to_string(k + 1);
                const base::Place place = places.at(each.source().begin);
                entries.push_back({name, TomlTable{}, TomlOrigin::file, place, place});
                collect(each, name + ".", depth + 1, places, entries);
            }
            continue;
        }
        entries.push_back(
            {full, value_of(node), TomlOrigin::file, places.at(key.source().begin), places.at(node.source().begin)});
        const toml::table* inner = depth < deepest ? node.as_table() : nullptr;
        if (inner != nullptr) collect(*inner, full + ".", depth + 1, places, entries);
    }
}

// The parser calls itself for each list or table in another, and tables go as deep as their dotted names. Counts both
// roughly: brackets and points in comments and texts, too.
bool is_deep(std::string_view text) {
    std::ptrdiff_t depth = 0;
    std::ptrdiff_t names = 0;
    for (const char c : text) {
        if (c == '.' && ++names > deepest_text) return true;
        if (c == '=' || c == ',' || c == '\n' || c == '{') names = 0;
        if ((c == '[' || c == '{') && ++depth > deepest_text) return true;
        if ((c == ']' || c == '}') && depth > 0) --depth;
    }
    return false;
}

void check_kind(const std::string& path, std::string_view text) {
    constexpr std::size_t beginning = 4096;  // [bytes]
    if (!recordings::has_recording_name(path) && !recordings::is_recording(text.substr(0, beginning))) return;
    throw Error(ErrorKind::input,
                {"this is a recording, not a case", "a case is a text of keys and values",
                 "`stridor classify " + path + "` judges it."},
                base::Place{path, 0, 0, ""});
}

// so many points in names: of "1.5" in a list it is none, of "1.5 = ..." and "[1.5]" it is one
std::ptrdiff_t points_in_names(std::string_view text) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_+-.";
    std::ptrdiff_t points = 0;
    for (std::size_t from = text.find_first_of(letters); from < text.size();) {
        const std::size_t to = std::min(text.find_first_not_of(letters, from), text.size());
        const std::string_view word = text.substr(from, to - from);
        const std::ptrdiff_t here = std::count(word.begin(), word.end(), '.');
        const std::size_t next = std::min(text.find_first_not_of(" \t", to), text.size());
        const bool is_key = text.substr(next).starts_with('=');
        const bool is_header = from > 0 && text[from - 1] == '[' && text.substr(next).starts_with(']');
        const bool may_be_number =
            here == 1 && std::string_view("0123456789+-").find(word.front()) != std::string_view::npos;
        if (!may_be_number || is_key || is_header) points += here;
        from = text.find_first_of(letters, to);
    }
    return points;
}

void check_size(const TomlSource& source) {
    const bool is_large = source.text.size() > largest_file;
    const std::ptrdiff_t points = is_large ? 0 : points_in_names(source.text);
    if (!is_large && points <= most_points) return;
    const std::string has =
        is_large
            ? std::to_string(source.text.size()) + " bytes; at most " + std::to_string(largest_file) + " make sense"
            : std::to_string(points) + " points in its names; at most " + std::to_string(most_points) + " make sense";
    throw Error(ErrorKind::input, {"this is no case file", "it has " + has, ""}, base::Place{source.name, 0, 0, ""});
}

void check_depth(const TomlSource& source) {
    if (!is_deep(source.text)) return;
    throw Error(
        ErrorKind::input,
        {"this is no case file",
         "its lists, tables or names stand in each other more than " + std::to_string(deepest_text) + " deep", ""},
        base::Place{source.name, 0, 0, ""});
}

}  // namespace

TomlSource load_toml(const std::string& path, std::vector<std::string> overrides) {
    std::string text = storage::read_file(path);
    check_kind(path, text);
    return {std::move(text), path == storage::standard_input ? "<stdin>" : path, std::move(overrides)};
}

const TomlEntry* TomlDocument::find(std::string_view key, std::size_t joint) const {
    const auto last = std::find_if(entries.rbegin(), entries.rend(), [&](const auto& entry) {
        return entry.key == key && (!entry.joint || *entry.joint == joint);
    });
    return last == entries.rend() ? nullptr : &*last;
}

TomlDocument parse_toml(const TomlSource& source) {
    check_size(source);
    check_depth(source);
    const Places places(source.text, source.name);
    TomlDocument document{source.name, {}};
    collect(parsed(source.text, places), "", 1, places, document.entries);
    // the parser sorts by name; people read from top to bottom
    const auto position = [](const TomlEntry& entry) {
        return std::tuple(entry.key_place.line, entry.key_place.column);
    };
    std::stable_sort(document.entries.begin(), document.entries.end(),
                     [&](const TomlEntry& a, const TomlEntry& b) { return position(a) < position(b); });
    for (const std::string& text : source.overrides)
        document.entries.push_back(parse_override(text));
    return document;
}

namespace {

// "mu_d" is contact.kinetic_friction; what no field is called, as a key of a chart, stays what it is
std::string full_key(const std::string& name, const base::Place& place) {
    const bool is_of_joint = parameters::joint_key(name).has_value() && parameters::find_field(name) == nullptr;
    if (!is_of_joint && parameters::fields_called(name).empty()) return name;
    try {
        return parameters::key_called(name);
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), place);
    }
}

}  // namespace

TomlEntry parse_override(const std::string& text) {
    const base::Place place{"--set", 0, 0, text};
    // the parser checks files; overrides come straight from the command line or a request
    if (!base::is_utf8(text))
        throw Error(ErrorKind::input, {"an override is not UTF-8 text", other_encoding, "Type it in UTF-8."}, place);
    if (base::has_control(text))
        throw Error(ErrorKind::input,
                    {"\"" + base::visible(text) + "\" holds a control character", "an override is one line of text",
                     "Write it without line ends and tabs."},
                    place);
    const std::size_t equals = text.find('=');
    const std::string key(base::trimmed(std::string_view(text).substr(0, equals)));
    if (equals == std::string::npos || key.empty())
        throw Error(ErrorKind::input,
                    {"\"" + text + "\" sets nothing", "an override reads section.key=value",
                     "Write for example contact.preload=20."},
                    place);
    std::string_view value = base::trimmed(std::string_view(text).substr(equals + 1));
    // quotes that the shell left alone: --set 'drive.kind="constant"'
    if (value.size() >= 2 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
    return {full_key(key, place), std::string(value), TomlOrigin::override, place, place};
}

std::vector<std::string> listed(std::string text) {
    std::erase_if(text, [](char c) { return c == '[' || c == ']' || c == '"'; });
    std::vector<std::string> list;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(',', start), text.size());
        list.emplace_back(base::trimmed(std::string_view(text).substr(start, end - start)));
        start = end + 1;
    }
    return list;
}

std::string_view type_name(const TomlValue& value) {
    struct Name {
        std::string_view operator()(double) const { return "a number"; }
        std::string_view operator()(const std::string&) const { return "text"; }
        std::string_view operator()(const std::vector<std::string>&) const { return "a list"; }
        std::string_view operator()(const std::vector<double>&) const { return "a list of numbers"; }
        std::string_view operator()(const TomlRows&) const { return "a matrix"; }
        std::string_view operator()(const TomlTable&) const { return "a section"; }
        std::string_view operator()(const TomlUnfit& unfit) const { return unfit.type; }
    };
    return std::visit(Name{}, value);
}

Error located(const Error& error, std::string_view key, const base::Place& place) {
    base::Problem problem = error.problem();
    const bool names_key = problem.what.find(key) != std::string::npos;
    const bool opens_with_value = problem.what.starts_with('"');
    if (!names_key) problem.what = std::string(key) + (opens_with_value ? " = " : ": ") + problem.what;
    return {error.kind(), std::move(problem), place};
}

}  // namespace stridor::io
