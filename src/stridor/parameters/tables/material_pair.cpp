#include "stridor/parameters/tables/material_pair.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace stridor::parameters {

namespace {

constexpr std::array<PairColumn, 3> conditions{{
    {"temperature", "degC", "temperature.value", &MaterialPair::temperature, &PairRow::temperature},
    {"humidity", "1", "contact.humidity", &MaterialPair::humidity, &PairRow::humidity},
    {"load", "N", "contact.preload", &MaterialPair::load, &PairRow::load},
}};
constexpr std::array<PairColumn, 7> coefficients{{
    {"static_friction", "1", "contact.static_friction", &MaterialPair::static_friction, &PairRow::static_friction,
     &Contact::static_friction},
    {"kinetic_friction", "1", "contact.kinetic_friction", &MaterialPair::kinetic_friction, &PairRow::kinetic_friction,
     &Contact::kinetic_friction},
    {"friction_slope", "s/m", "contact.friction_slope", &MaterialPair::friction_slope, &PairRow::friction_slope,
     &Contact::friction_slope},
    {"stribeck_velocity", "m/s", "contact.stribeck_velocity", &MaterialPair::stribeck_velocity,
     &PairRow::stribeck_velocity, &Contact::stribeck_velocity},
    {"stribeck_exponent", "1", "contact.stribeck_exponent", &MaterialPair::stribeck_exponent,
     &PairRow::stribeck_exponent, &Contact::stribeck_exponent},
    {"viscous_friction", "s/m", "contact.viscous_friction", &MaterialPair::viscous_friction, &PairRow::viscous_friction,
     &Contact::viscous_friction},
    {"rest_growth", "1", "contact.rest_growth", &MaterialPair::rest_growth, &PairRow::rest_growth,
     &Contact::rest_growth},
}};
constexpr std::size_t needed = 2;  // of the coefficients: each pair has these

// a condition without nodes has one value
std::size_t size_of(const std::vector<double>& nodes) {
    return std::max<std::size_t>(nodes.size(), 1);
}

std::size_t point_count(const MaterialPair& pair) {
    return size_of(pair.temperature) * size_of(pair.humidity) * size_of(pair.load);
}

std::size_t place_of(const MaterialPair& pair, std::size_t temperature, std::size_t humidity, std::size_t load) {
    return (temperature * size_of(pair.humidity) + humidity) * size_of(pair.load) + load;
}

// two nodes and how far the value lies between them [1]; twice the nearer one outside
struct Between {
    std::size_t low = 0;
    std::size_t high = 0;
    double share = 0.0;
};

Between between_nodes(const std::vector<double>& nodes, double value) {
    if (nodes.empty() || value <= nodes.front()) return {};
    if (value >= nodes.back()) return {nodes.size() - 1, nodes.size() - 1, 0.0};
    const auto above = static_cast<std::size_t>(std::upper_bound(nodes.begin(), nodes.end(), value) - nodes.begin());
    return {above - 1, above, (value - nodes[above - 1]) / (nodes[above] - nodes[above - 1])};
}

double between_values(double low, double high, double share) {
    // rounding must not carry a value beyond its neighbours
    return std::clamp(low + share * (high - low), std::min(low, high), std::max(low, high));
}

struct PairPlace {
    Between temperature;
    Between humidity;
    Between load;
};

double coefficient_at(const MaterialPair& pair, const std::vector<double>& values, const PairPlace& at) {
    const auto over_load = [&](std::size_t temperature, std::size_t humidity) {
        return between_values(values[place_of(pair, temperature, humidity, at.load.low)],
                              values[place_of(pair, temperature, humidity, at.load.high)], at.load.share);
    };
    const auto over_humidity = [&](std::size_t temperature) {
        return between_values(over_load(temperature, at.humidity.low), over_load(temperature, at.humidity.high),
                              at.humidity.share);
    };
    return between_values(over_humidity(at.temperature.low), over_humidity(at.temperature.high), at.temperature.share);
}

void expect_coefficients(double static_friction, double kinetic_friction, const std::string& where) {
    const double least = std::min(static_friction, kinetic_friction);
    if (!(least >= 0.0))
        base::refuse("the pair has a coefficient of " + base::shortest(least) + where, "friction acts against the slip",
                     "Give its size.");
    if (kinetic_friction > static_friction)
        base::refuse("the pair has mu_d = " + base::shortest(kinetic_friction) +
                         " above mu_s = " + base::shortest(static_friction) + where,
                     "kinetic friction may not be larger than static", "Swap them?");
}

// within what a case may say itself
void expect_number(const PairColumn& column, double value, const std::string& where) {
    try {
        expect_in_range(Case(), *find_field(column.field), value);
    } catch (const Error& error) {
        base::Problem problem = error.problem();
        problem.what += where;
        throw Error(error.kind(), problem);
    }
}

std::string conditions_text(const PairRow& row) {
    std::string text;
    for (const PairColumn& condition : conditions)
        if (const std::optional<double>& value = row.*condition.in_row)
            text += (text.empty() ? " at " : ", ") + std::string(condition.name) + " " +
                    base::quantity_text(*value, condition.unit);
    return text;
}

// where a value stands among the nodes, which have it
std::size_t node_of(const std::vector<double>& nodes, const std::optional<double>& value) {
    if (!value) return 0;
    return static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), *value) - nodes.begin());
}

std::vector<double> numbers_of(std::string_view list, const PairColumn& of) {
    std::vector<double> numbers;
    while (!list.empty()) {
        const std::size_t end = list.find(',');
        numbers.push_back(base::parse_quantity(base::trimmed(list.substr(0, end)), of.unit));
        list.remove_prefix(end == std::string_view::npos ? list.size() : end + 1);
    }
    return numbers;
}

void expect_in_all_or_none(std::span<const PairRow> rows, const PairColumn& column, const char* why) {
    for (const PairRow& row : rows)
        if ((row.*column.in_row).has_value() != (rows.front().*column.in_row).has_value())
            base::refuse("some rows of the pair have no " + std::string(column.name), why,
                         "Write it in all of them, or in none.");
}

std::string names_of_columns() {
    std::string names;
    for (const std::span<const PairColumn> columns : {pair_conditions(), pair_coefficients()})
        for (const PairColumn& column : columns)
            names += (names.empty() ? "" : ", ") + std::string(column.name);
    return names;
}

void expect_grid(const MaterialPair& pair) {
    for (const PairColumn& condition : conditions) {
        const std::vector<double>& nodes = pair.*condition.values;
        for (std::size_t k = 1; k < nodes.size(); ++k)
            if (!(nodes[k] > nodes[k - 1]))
                base::refuse(std::string(condition.name) + " of the pair does not rise: " + base::shortest(nodes[k]) +
                                 " follows " + base::shortest(nodes[k - 1]),
                             "a table is read from its lowest to its highest value", "Sort it.");
    }
    const std::size_t points = point_count(pair);
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
        const PairColumn& column = coefficients[k];
        const std::vector<double>& values = pair.*column.values;
        if (values.empty() && k >= needed) continue;
        if (values.size() != points)
            base::refuse("the pair has " + std::to_string(values.size()) + " values of " + std::string(column.name) +
                             " at " + std::to_string(points) + " points",
                         "it has one at each", "");
        if (k >= needed)
            for (const double value : values)
                expect_number(column, value, "");
    }
    for (std::size_t k = 0; k < points; ++k)
        expect_coefficients(pair.static_friction[k], pair.kinetic_friction[k], "");
}

}  // namespace

std::span<const PairColumn> pair_conditions() {
    return conditions;
}

std::span<const PairColumn> pair_coefficients() {
    return coefficients;
}

MaterialPair pair_of_rows(std::span<const PairRow> rows) {
    MaterialPair pair;
    for (const PairColumn& condition : conditions) {
        expect_in_all_or_none(rows, condition, "a pair depends on it or does not");
        std::vector<double>& nodes = pair.*condition.values;
        for (const PairRow& row : rows)
            if (const std::optional<double>& value = row.*condition.in_row) nodes.push_back(*value);
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    }
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
        if (k < needed && !(rows.front().*coefficients[k].in_row))
            base::refuse("the pair has no " + std::string(coefficients[k].name), "a pair has both coefficients", "");
        expect_in_all_or_none(rows, coefficients[k], "it is known at every point or at none");
    }
    std::vector<const PairRow*> points(point_count(pair));
    for (const PairRow& row : rows) {
        expect_coefficients(*row.static_friction, *row.kinetic_friction, conditions_text(row));
        for (const PairColumn& column : std::span(coefficients).subspan(needed))
            if (const std::optional<double>& value = row.*column.in_row)
                expect_number(column, *value, conditions_text(row));
        const PairRow*& point = points[place_of(pair, node_of(pair.temperature, row.temperature),
                                                node_of(pair.humidity, row.humidity), node_of(pair.load, row.load))];
        if (point != nullptr)
            base::refuse("the pair has two rows" + conditions_text(row), "coefficients are a function of these",
                         "Remove one of the two, or give their mean.");
        point = &row;
    }
    const auto none = std::find(points.begin(), points.end(), nullptr);
    if (none != points.end()) {
        const auto place = static_cast<std::size_t>(none - points.begin());
        const std::size_t loads = size_of(pair.load);
        const std::size_t humidities = size_of(pair.humidity);
        PairRow missing;
        if (!pair.temperature.empty()) missing.temperature = pair.temperature[place / loads / humidities];
        if (!pair.humidity.empty()) missing.humidity = pair.humidity[place / loads % humidities];
        if (!pair.load.empty()) missing.load = pair.load[place % loads];
        base::refuse("the pair has no row" + conditions_text(missing),
                     "its rows are a full plan: each temperature with each humidity and each load",
                     "Measure it, or leave out the others there.");
    }
    for (const PairColumn& column : coefficients)
        for (const PairRow* point : points)
            if (const std::optional<double>& value = point->*column.in_row) (pair.*column.values).push_back(*value);
    return pair;
}

std::string material_pair_text(const MaterialPair& pair) {
    if (pair.static_friction.empty()) return pair.source;
    std::string text;
    const auto add = [&](const PairColumn& list) {
        if ((pair.*list.values).empty()) return;
        text += (text.empty() ? "" : "; ") + std::string(list.name) + ": ";
        for (std::size_t k = 0; k < (pair.*list.values).size(); ++k)
            text += (k == 0 ? "" : ", ") + base::shortest((pair.*list.values)[k]);
    };
    for (const PairColumn& condition : conditions)
        add(condition);
    for (const PairColumn& column : coefficients)
        add(column);
    return text;
}

bool is_whole_pair(std::string_view text) {
    return text.find(';') != std::string_view::npos;
}

NamedPair named_pair(std::string_view text) {
    constexpr std::string_view ending = ".toml:";
    const std::size_t found = text.find(ending);
    NamedPair named;
    if (found != std::string_view::npos)
        named = {std::string(base::trimmed(text.substr(0, found + ending.size() - 1))),
                 std::string(base::trimmed(text.substr(found + ending.size())))};
    if (named.file.empty() || named.name.empty())
        base::refuse("\"" + std::string(text) + "\" names no pair of materials", "a file and a pair in it are named",
                     "Write \"pairs.toml: EPDM on glass\".");
    return named;
}

MaterialPair parse_material_pair(std::string_view text) {
    MaterialPair pair;
    pair.source = base::trimmed(text);
    if (pair.source.empty()) return pair;
    if (!is_whole_pair(text)) return pair;
    while (!text.empty()) {
        const std::size_t end = text.find(';');
        const std::string_view one = base::trimmed(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        const std::size_t colon = one.find(':');
        const std::string_view name = base::trimmed(one.substr(0, colon));
        const auto read = [&](const auto& lists) {
            for (const PairColumn& list : lists)
                if (list.name == name && colon != std::string_view::npos && (pair.*list.values).empty()) {
                    pair.*list.values = numbers_of(one.substr(colon + 1), list);
                    return true;
                }
            return false;
        };
        if (!read(conditions) && !read(coefficients))
            base::refuse("\"" + std::string(one) + "\" is no part of a pair of materials",
                         "these are " + names_of_columns() + ", each once",
                         "Write \"load: 5, 10; static_friction: 0.8, 0.7; kinetic_friction: 0.6, 0.5\".");
    }
    expect_grid(pair);
    pair.source = material_pair_text(pair);
    return pair;
}

bool follows_pair(CaseView at, const Field& field) {
    const std::string key = key_of(field);
    return std::any_of(coefficients.begin(), coefficients.end(), [&](const PairColumn& column) {
        return column.field == key && !(at.own().contact.pair.*column.values).empty();
    });
}

bool follows_table(CaseView at, const Field& field) {
    return temperature_column(at, field) != nullptr || follows_pair(at, field);
}

bool follows_table(const Case& c, std::string_view key) {
    if (temperature_column(c, key) != nullptr) return true;
    return std::any_of(coefficients.begin(), coefficients.end(), [&](const PairColumn& column) {
        if (!key.ends_with(column.field)) return false;
        return std::any_of(c.joints.begin(), c.joints.end(),
                           [&](const PlateJoint& joint) { return !(joint.contact.pair.*column.values).empty(); });
    });
}

std::span<const double> pair_nodes(const MaterialPair& pair, const Field& field) {
    const std::string key = key_of(field);
    for (const PairColumn& condition : conditions)
        if (condition.field == key) return pair.*condition.values;
    return {};
}

void keep_pairs(Case& c) {
    for (PlateJoint& joint : c.joints) {
        Contact& contact = joint.contact;
        const MaterialPair& pair = contact.pair;
        if (pair.static_friction.empty()) continue;
        const PairPlace at{between_nodes(pair.temperature, c.temperature.value),
                           between_nodes(pair.humidity, contact.humidity), between_nodes(pair.load, contact.preload)};
        for (const PairColumn& column : coefficients)
            if (const std::vector<double>& values = pair.*column.values; !values.empty())
                contact.*column.follows = coefficient_at(pair, values, at);
    }
}

}  // namespace stridor::parameters
