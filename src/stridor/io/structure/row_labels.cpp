#include "stridor/io/structure/row_labels.hpp"

#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stridor::io::structure {

namespace {

constexpr std::size_t most_sets = 100'000;
constexpr std::size_t most_set_nodes = 4'000'000;  // [1] of all sets, some 130 MB; a model has a set of all its nodes

namespace csv = recordings::csv_table;
using recordings::LineReader;
using recordings::place_of;
using recordings::refusal;
using recordings::TextLine;

constexpr std::array<std::string_view, 6> known_columns{"node", "component", "x", "y", "z", "set"};

/// Where each known column stands; none: it is not there.
struct RowColumns {
    csv::Dialect dialect;
    std::array<std::optional<std::size_t>, known_columns.size()> places{};
    std::array<double, 3> lengths{1.0, 1.0, 1.0};  // [m] units of x, y, z
};

std::string_view without_mark(std::string_view text) {
    if (text.starts_with(csv::utf8_mark)) text.remove_prefix(csv::utf8_mark.size());
    return text;
}

RowColumns layout_of(const TextLine& line, const std::string& file) {
    RowColumns layout{csv::sniff(line.text)};
    const std::vector<csv::CsvField> fields = csv::split(without_mark(line.text), layout.dialect.delimiter);
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const csv::Title title = csv::title_of(fields[k].text);
        const auto known = std::find(known_columns.begin(), known_columns.end(), csv::lower(title.name));
        if (known == known_columns.end()) continue;
        const auto which = static_cast<std::size_t>(known - known_columns.begin());
        layout.places.at(which) = k;
        if (which < 2 || which > 4 || title.unit.empty()) continue;
        const auto unit = base::find_unit(title.unit);
        if (!unit || !(unit->dimension == base::Dimension{.length = 1}))
            throw refusal(place_of(file, line, fields[k].column), fmt::format("\"{}\" is no length", title.unit));
        layout.lengths.at(which - 2) = unit->factor;
    }
    if (!layout.places[0])
        throw refusal(place_of(file, line, 1), "the table has no column \"node\"",
                      "its first line names node, component, and if they are known x, y, z and set");
    return layout;
}

class TableReader {
public:
    TableReader(const StructureInput& input, const RowColumns& layout) : input_(input), layout_(layout) {}

    void take(const TextLine& line) {
        fields_ = csv::split(line.text, layout_.dialect.delimiter);
        const std::string node = field(0);
        if (node.empty()) throw refusal(place_of(input_.name, line, 1), "the row has no node");
        const std::string component = field(1);
        const auto number = component_in(component);
        if (!number)
            throw refusal(place_of(input_.name, line, 1), fmt::format("\"{}\" is no component", component),
                          "it is 1 to 6, UX to ROTZ, or empty");
        table_.labels.push_back({node, *number});
        take_position(line, node);
        take_sets(line, node);
    }

    RowTable finish() {
        table_.sets = sets_.take();
        return std::move(table_);
    }

private:
    std::string field(std::size_t column) const {
        const auto place = layout_.places.at(column);
        return place && *place < fields_.size() ? fields_[*place].text : std::string();
    }

    void take_position(const TextLine& line, const std::string& node) {
        if (!layout_.places[2] || !layout_.places[3] || !layout_.places[4]) return;
        Eigen::Vector3d position;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::string text = field(2 + axis);
            if (text.empty()) return;
            const auto value = csv::number_in(text, layout_.dialect);
            if (!value || !std::isfinite(*value))
                throw refusal(place_of(input_.name, line, 1), fmt::format("\"{}\" is no coordinate", text));
            position[static_cast<Eigen::Index>(axis)] = *value * layout_.lengths.at(axis);
        }
        table_.positions[node] = position;
    }

    void take_sets(const TextLine& line, const std::string& node) {
        const std::string text = field(5);
        for (const std::string_view word : recordings::words(text)) {
            const std::string name(word);
            const std::size_t place = sets_.place_of(name, name);
            if (const auto problem = sets_.excess(1))
                throw refusal(place_of(input_.name, line, 1), problem->what, problem->why, problem->suggestion);
            const std::vector<std::string>& nodes = sets_.nodes_of(place);
            if (nodes.empty() || nodes.back() != node) sets_.add(place, node);
        }
    }

    const StructureInput& input_;
    const RowColumns& layout_;
    std::vector<csv::CsvField> fields_;
    RowTable table_;
    SetTable sets_;
};

}  // namespace

std::size_t SetTable::place_of(const std::string& key, const std::string& name) {
    const auto [found, is_new] = places_.try_emplace(key, sets_.size());
    if (is_new) sets_.push_back({name, {}});
    return found->second;
}

std::optional<std::size_t> SetTable::find(const std::string& key) const {
    const auto found = places_.find(key);
    return found == places_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<base::Problem> SetTable::excess(std::size_t nodes) const {
    if (sets_.size() > most_sets)
        return base::Problem{fmt::format("there are more than {} node sets", most_sets), "so many are not read",
                             "Leave out those that no contact and no force needs."};
    if (nodes > most_set_nodes - nodes_)
        return base::Problem{fmt::format("the node sets hold more than {} nodes together", most_set_nodes),
                             "so many are not read", "Leave out the sets that no contact and no force needs."};
    return std::nullopt;
}

void SetTable::add(std::size_t place, std::string node) {
    sets_[place].nodes.push_back(std::move(node));
    ++nodes_;
}

std::optional<int> component_in(std::string_view text) {
    constexpr std::array<std::string_view, 6> ansys{"UX", "UY", "UZ", "ROTX", "ROTY", "ROTZ"};
    constexpr std::array<std::string_view, 6> short_names{"X", "Y", "Z", "RX", "RY", "RZ"};
    const std::string large = upper(base::trimmed(text));
    if (large.empty() || large == "0" || large == "NONE") return 0;
    if (large.size() == 1 && large[0] >= '1' && large[0] <= '6') return large[0] - '0';
    for (std::size_t k = 0; k < ansys.size(); ++k)
        if (large == ansys.at(k) || large == short_names.at(k)) return static_cast<int>(k) + 1;
    return std::nullopt;
}

bool is_row_table(std::string_view first_line) {
    const std::vector<csv::CsvField> fields = csv::split(without_mark(first_line), csv::sniff(first_line).delimiter);
    return std::any_of(fields.begin(), fields.end(),
                       [](const csv::CsvField& each) { return csv::lower(csv::title_of(each.text).name) == "node"; });
}

RowTable read_row_table(const StructureInput& input) {
    LineReader lines(input.bytes, input.name);
    auto line = lines.next();
    while (line && (base::trimmed(line->text).empty() || line->text.starts_with('#')))
        line = lines.next();
    if (!line) throw refusal(input.name, "the table is empty");
    const RowColumns layout = layout_of(*line, input.name);
    TableReader reader(input, layout);
    while (const auto row = lines.next())
        if (!base::trimmed(row->text).empty()) reader.take(*row);
    return reader.finish();
}

}  // namespace stridor::io::structure
