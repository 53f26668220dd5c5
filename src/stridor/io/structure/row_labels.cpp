#include "stridor/io/structure/row_labels.hpp"

#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/csv_table.hpp"
#include "stridor/recordings/table/named_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace stridor::io::structure {

namespace {

constexpr std::size_t most_sets = 100'000;
constexpr std::size_t most_set_nodes = 4'000'000;  // [1] of all sets, some 130 MB; a model has a set of all its nodes

namespace csv = recordings::csv_table;
using recordings::NamedColumn;
using recordings::refusal;

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

class LabelReader {
public:
    explicit LabelReader(const StructureInput& input) : rows_(input.bytes, input.name) {
        if (!rows_.has("node"))
            throw refusal(rows_.columns().front().place, "the table has no column \"node\"",
                          "its first line names node, component, and if they are known x, y, z and set");
        for (const NamedColumn& column : rows_.columns()) {
            const auto axis = std::find(axes.begin(), axes.end(), column.name);
            if (axis == axes.end() || column.unit.empty()) continue;
            const auto unit = base::find_unit(column.unit);
            if (!unit || !(unit->dimension == base::Dimension{.length = 1}))
                throw refusal(column.place, fmt::format("\"{}\" is no length", column.unit));
            lengths_.at(static_cast<std::size_t>(axis - axes.begin())) = unit->factor;
        }
        has_positions_ = std::all_of(axes.begin(), axes.end(), [&](std::string_view axis) { return rows_.has(axis); });
    }

    RowTable read() {
        while (rows_.next())
            take_row();
        table_.sets = sets_.take();
        return std::move(table_);
    }

private:
    void take_row() {
        const std::string node = rows_.text("node");
        if (node.empty()) throw refusal(rows_.place(), "the row has no node");
        const std::string component = rows_.text("component");
        const auto number = component_in(component);
        if (!number)
            throw refusal(rows_.place(), fmt::format("\"{}\" is no component", component),
                          "it is 1 to 6, UX to ROTZ, or empty");
        table_.labels.push_back({node, *number});
        if (has_positions_) take_position(node);
        take_sets(node);
    }

    void take_position(const std::string& node) {
        Eigen::Vector3d position;
        for (std::size_t k = 0; k < axes.size(); ++k) {
            const std::string text = rows_.text(axes.at(k));
            if (text.empty()) return;
            const auto value = rows_.number(axes.at(k));
            if (!value) throw refusal(rows_.place(), fmt::format("\"{}\" is no coordinate", text));
            position[static_cast<Eigen::Index>(k)] = *value * lengths_.at(k);
        }
        table_.positions[node] = position;
    }

    void take_sets(const std::string& node) {
        const std::string text = rows_.text("set");
        for (const std::string_view word : recordings::words(text)) {
            const std::string name(word);
            const std::size_t place = sets_.place_of(name, name);
            if (const auto problem = sets_.excess(1))
                throw refusal(rows_.place(), problem->what, problem->why, problem->suggestion);
            const std::vector<std::string>& nodes = sets_.nodes_of(place);
            if (nodes.empty() || nodes.back() != node) sets_.add(place, node);
        }
    }

    recordings::NamedTable rows_;
    std::array<double, 3> lengths_{1.0, 1.0, 1.0};  // [m] units of x, y, z
    bool has_positions_ = false;
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
    if (first_line.starts_with(csv::utf8_mark)) first_line.remove_prefix(csv::utf8_mark.size());
    const std::vector<csv::CsvField> fields = csv::split(first_line, csv::sniff(first_line).delimiter);
    return std::any_of(fields.begin(), fields.end(),
                       [](const csv::CsvField& each) { return csv::lower(csv::title_of(each.text).name) == "node"; });
}

RowTable read_row_table(const StructureInput& input) {
    return LabelReader(input).read();
}

}  // namespace stridor::io::structure
