#include "stridor/io/case/material_pairs.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/tables/material_pair.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::io {

namespace {

using parameters::PairRow;

std::vector<std::string_view> row_keys() {
    std::vector<std::string_view> keys{"name", "source"};
    for (const auto& columns : {parameters::pair_conditions(), parameters::pair_coefficients()})
        for (const parameters::PairColumn& column : columns)
            keys.push_back(column.name);
    return keys;
}

double number_of_row(const TomlEntry& entry, std::string_view unit) {
    try {
        if (const auto* text = std::get_if<std::string>(&entry.value)) return base::parse_quantity(*text, unit);
        const auto* number = std::get_if<double>(&entry.value);
        if (number != nullptr && std::isfinite(*number)) return *number;
        base::refuse("a pair takes numbers", "this is " + std::string(type_name(entry.value)), "");
    } catch (const Error& error) {
        throw located(error, entry.key, entry.value_place);
    }
}

void expect_row_keys(const TomlDocument& document, const std::string& table) {
    const std::vector<std::string_view> known = row_keys();
    for (const TomlEntry& entry : document.entries) {
        if (!entry.key.starts_with(table + ".")) continue;
        const std::string key = entry.key.substr(table.size() + 1);
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        const std::string_view near = base::nearest_name(key, known);
        throw Error(ErrorKind::input,
                    {"unknown key " + base::visible(key) + " of a pair", "",
                     near.empty() ? "" : "Did you mean " + std::string(near) + "?"},
                    entry.key_place);
    }
}

PairRow row_in(const TomlDocument& document, const TomlEntry& table) {
    expect_row_keys(document, table.key);
    PairRow row;
    for (const auto& columns : {parameters::pair_conditions(), parameters::pair_coefficients()})
        for (const parameters::PairColumn& column : columns)
            if (const TomlEntry* entry = document.find(table.key + "." + std::string(column.name)))
                row.*column.in_row = number_of_row(*entry, column.unit);
    for (const auto& [number, key] :
         {std::pair(row.static_friction, "static_friction"), std::pair(row.kinetic_friction, "kinetic_friction")})
        if (!number)
            throw Error(ErrorKind::input, {"this row has no " + std::string(key), "a pair has both coefficients", ""},
                        table.key_place);
    return row;
}

}  // namespace

parameters::MaterialPair read_material_pair(const std::string& path, const std::string& name) {
    const TomlDocument document = parse_toml(load_toml(path));
    std::vector<PairRow> rows;
    std::set<std::string> names;
    std::optional<base::Place> first;
    for (std::size_t number = 1;; ++number) {
        const TomlEntry* table = document.find("pair." + std::to_string(number));
        if (table == nullptr) break;
        const TomlEntry* entry = document.find(table->key + ".name");
        const auto* called = entry == nullptr ? nullptr : std::get_if<std::string>(&entry->value);
        if (called == nullptr)
            throw Error(ErrorKind::input, {"this row has no name", "it says of which pair it is", ""},
                        table->key_place);
        names.insert(*called);
        if (*called != name) continue;
        rows.push_back(row_in(document, *table));
        if (!first) first = table->key_place;
    }
    if (rows.empty()) {
        const std::vector<std::string_view> known(names.begin(), names.end());
        const std::string_view near = base::nearest_name(name, known);
        std::string all;
        for (const std::string& each : names)
            all += (all.empty() ? "" : ", ") + base::visible(each);
        throw Error(ErrorKind::input,
                    {"there is no pair \"" + base::visible(name) + "\"",
                     names.empty() ? "the file has no [[pair]]" : "it has " + all,
                     near.empty() ? "" : "Did you mean \"" + base::visible(std::string(near)) + "\"?"},
                    base::Place{path, 0, 0, ""});
    }
    try {
        return parameters::pair_of_rows(rows);
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), *first);
    }
}

}  // namespace stridor::io
