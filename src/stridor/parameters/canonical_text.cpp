// The text by which results are kept: what changes a result stands in it, and nothing else.

#include "stridor/base/hash.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/tables/material_pair.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <string>

namespace stridor::parameters {

namespace {

// does a line of it stand in the canonical text?
bool is_canonical(CaseView at, const Field& field) {
    const auto* text = std::get_if<Text>(&field.kind);
    // a title or a file name changes no result
    const bool names_a_thing = text != nullptr && text->means != Text::Means::numbers;
    const bool follows = follows_table(at, field);
    const bool is_content = is_of_builder(field);  // structure.content says it
    return field.belongs(at) && !names_a_thing && !is_content && !follows && !goes_without_saying(at, field);
}

}  // namespace

std::string canonical_text(const Case& c) {
    std::string text;
    if (c.own_structure) text += "structure.content = " + content_hash(*c.own_structure) + "\n";
    for (const auto& [field, at, key] : fields_of(c))
        if (is_canonical(at, field)) text += key + " = " + value_text(at, field) + "\n";
    if (has_temperature_table(c)) text += "temperature.at = " + base::listed(node_texts(c)) + "\n";
    for (const TemperatureColumn& column : c.temperature.columns)
        text += "temperature." + column.key + " = " + base::listed(value_texts(column)) + "\n";
    if (is_of_file(c.drive)) {
        std::string samples;
        for (std::size_t k = 0; k < c.drive.times.size(); ++k)
            samples += base::shortest(c.drive.times[k]) + "," + base::shortest(c.drive.velocities[k]) + "\n";
        text += "drive.samples = " + base::hash_text(samples) + "\n";
    }
    return text;
}

}  // namespace stridor::parameters
