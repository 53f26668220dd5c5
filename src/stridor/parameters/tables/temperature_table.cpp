#include "stridor/parameters/tables/temperature_table.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/tables/damping_ratio.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace stridor::parameters {

namespace {

constexpr std::array<std::string_view, 11> followers{
    "joint.axial_stiffness",     "joint.flexural_stiffness", "joint.axial_damping",
    "joint.flexural_damping",    "plate.stiffness",          "plate.damping",
    "contact.static_friction",   "contact.kinetic_friction", "contact.friction_slope",
    "contact.stribeck_velocity", "contact.viscous_friction"};

const Field& temperature_field() {
    return *find_field("temperature.value");
}

std::ptrdiff_t rank(std::string_view key) {
    return std::find(followers.begin(), followers.end(), key) - followers.begin();
}

// which joint a column is of, and its key without that name; of the only one, and of the plate, behind all
struct Followed {
    std::size_t joint;
    std::string key;
};

Followed followed(const Case& c, const TemperatureColumn& column) {
    const std::optional<JointKey> named = joint_key(column.key);
    if (!named) return {c.joints.size(), column.key};
    const auto found = std::find_if(c.joints.begin(), c.joints.end(),
                                    [&](const PlateJoint& joint) { return joint.name == named->joint; });
    STRIDOR_EXPECT(found != c.joints.end());
    return {static_cast<std::size_t>(found - c.joints.begin()), named->key};
}

double interpolated(const std::vector<double>& at, const std::vector<double>& values, double temperature) {
    const auto above = static_cast<std::size_t>(std::upper_bound(at.begin(), at.end(), temperature) - at.begin());
    if (above == 0) return values.front();
    if (above == at.size()) return values.back();
    const double low = values[above - 1];
    const double high = values[above];
    const double share = (temperature - at[above - 1]) / (at[above] - at[above - 1]);
    // rounding must not carry a value beyond its neighbours
    return std::clamp(low + share * (high - low), std::min(low, high), std::max(low, high));
}

}  // namespace

std::span<const std::string_view> keys_over_temperature() {
    return followers;
}

bool has_temperature_table(const Case& c) {
    return !c.temperature.at.empty();
}

const TemperatureColumn* temperature_column(const Case& c, std::string_view key) {
    const auto& columns = c.temperature.columns;
    const auto found = std::find_if(columns.begin(), columns.end(), [&](const TemperatureColumn& each) {
        if (each.key == key) return true;
        const std::optional<JointKey> named = joint_key(each.key);
        return named && named->key == key;
    });
    return found == columns.end() ? nullptr : &*found;
}

const TemperatureColumn* temperature_column(CaseView at, const Field& field) {
    const std::string key = key_at(at, field);
    const auto& columns = at.c.temperature.columns;
    const auto found = std::find_if(columns.begin(), columns.end(), [&](const auto& each) { return each.key == key; });
    return found == columns.end() ? nullptr : &*found;
}

TemperatureColumn read_temperature_column(const Field& field, std::span<const std::string> texts) {
    TemperatureColumn column{key_of(field), {}, TemperatureColumn::Holds::quantity};
    std::size_t shares = 0;
    for (const std::string& text : texts) {
        Case probe;
        set_from_text(probe, field, text);
        const std::optional<double> ratio = damping_ratio(probe, field);
        if (ratio) ++shares;
        column.values.push_back(ratio ? *ratio : get_quantity(probe, field));
    }
    if (shares != 0 && shares != texts.size())
        base::refuse(column.key + " is a share of critical at some temperatures and none at others",
                     "nothing lies between the two", "Write all of them in one way.");
    if (shares != 0) column.holds = TemperatureColumn::Holds::damping_ratio;
    return column;
}

std::vector<double> read_temperature_nodes(std::span<const std::string> texts) {
    std::vector<double> at;
    for (const std::string& text : texts) {
        Case probe;
        set_from_text(probe, temperature_field(), text);
        const double node = get_quantity(probe, temperature_field());
        if (!at.empty() && !(node > at.back()))
            base::refuse(
                "temperature.at does not rise: " + base::shortest(node) + " follows " + base::shortest(at.back()),
                "a table is read from its coldest to its hottest node", "Sort its columns by temperature.");
        at.push_back(node);
    }
    if (at.size() < 2)
        base::refuse("temperature.at has too few temperatures: " + std::to_string(at.size()),
                     "values are interpolated between two at least", "");
    return at;
}

void check_length(const TemperatureColumn& column, std::size_t nodes) {
    if (column.values.size() != nodes)
        base::refuse(column.key + " has " + std::to_string(column.values.size()) + " values over " +
                         std::to_string(nodes) + " temperatures",
                     "a table has one value at each", "Make the list as long as temperature.at.");
}

void set_temperature_table(Case& c, std::vector<double> at, std::vector<TemperatureColumn> columns) {
    STRIDOR_EXPECT(at.size() >= 2 && std::is_sorted(at.begin(), at.end()));
    if (columns.empty())
        base::refuse("temperature.at stands alone", "nothing follows the temperature",
                     "Write for example axial_stiffness = [...] below it, with a value at each temperature.");
    const auto place = [&](const TemperatureColumn& column) {
        const Followed of = followed(c, column);
        return std::pair(of.joint, rank(of.key));
    };
    std::sort(columns.begin(), columns.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
    for (std::size_t k = 0; k < columns.size(); ++k) {
        STRIDOR_EXPECT(place(columns[k]).second < std::ssize(followers));
        check_length(columns[k], at.size());
        if (k > 0 && columns[k].key == columns[k - 1].key)
            base::refuse(columns[k].key + " stands twice in [temperature]", "a table has one column of it",
                         "Remove one of the two.");
    }
    c.temperature.value = std::clamp(c.temperature.value, at.front(), at.back());
    c.temperature.at = std::move(at);
    c.temperature.columns = std::move(columns);
    keep_temperature_table(c);
    keep_damping_ratios(c);
}

void keep_temperature_table(Case& c) {
    for (const TemperatureColumn& column : c.temperature.columns) {
        const Followed of = followed(c, column);
        const CaseToSet at(c, of.joint < c.joints.size() ? of.joint : 0);
        const double value = interpolated(c.temperature.at, column.values, c.temperature.value);
        std::optional<double>* ratio = damping_ratio_of(at, of.key);
        if (ratio != nullptr) ratio->reset();
        if (column.holds == TemperatureColumn::Holds::damping_ratio)
            *ratio = value;
        else
            std::get<Quantity>(find_field(of.key)->kind).set(at, value);
    }
}

std::vector<std::string> node_texts(const Case& c) {
    std::vector<std::string> texts;
    for (const double node : c.temperature.at)
        texts.push_back(base::shortest(node) + " " + std::string(unit_of(temperature_field())));
    return texts;
}

std::vector<std::string> value_texts(const TemperatureColumn& column) {
    const std::string_view unit = unit_of(column.key);
    std::vector<std::string> texts;
    for (const double value : column.values)
        texts.push_back(column.holds == TemperatureColumn::Holds::damping_ratio ? damping_ratio_text(value)
                        : unit == "1"                                           ? base::shortest(value)
                                      : base::shortest(value) + " " + std::string(unit));
    return texts;
}

}  // namespace stridor::parameters
