#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/explorer/answers/answers.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace stridor::explorer {

namespace {

using parameters::Case;
using parameters::Field;
using parameters::Quantity;

constexpr std::size_t longest_value = 100;  // characters of a number with its unit; what is longer is a slip

std::string plain_value(const Case& c, const Field& field) {
    const bool is_quantity = std::holds_alternative<Quantity>(field.kind);
    return is_quantity ? base::shortest(parameters::get_quantity(c, field)) : parameters::value_text(c, field);
}

// what has to be set in one case to make it the other; titles are words and stay behind
std::vector<std::string> changes(const Case& from, const Case& to) {
    std::vector<std::string> set;
    for (const Field& field : parameters::fields()) {
        const auto* text = std::get_if<parameters::Text>(&field.kind);
        const bool is_words = text != nullptr && text->means != parameters::Text::Means::numbers;
        if (!field.belongs(to) || is_words) continue;
        const std::string wanted = plain_value(to, field);
        if (!field.belongs(from) || plain_value(from, field) != wanted)
            set.push_back(parameters::key_of(field) + "=" + wanted);
    }
    return set;
}

Case read_preset(const Preset& preset, const std::vector<std::string>& set) {
    io::TomlSource source = source_of(preset);
    source.overrides.insert(source.overrides.end(), set.begin(), set.end());
    return io::read_case(io::parse_toml(source), readers_of(preset));
}

// as `--set` would take it; a number of a builder has no place in a case without its structure
double number_of(const Field& field, const std::string& text) {
    if (parameters::is_of_builder(field)) return base::parse_quantity(text, std::get<Quantity>(field.kind).unit);
    Case c;
    parameters::set_from_text(c, field, text);
    return parameters::get_quantity(c, field);
}

}  // namespace

Response value(const World&, const Json& body, const std::stop_token&) {
    const std::string key = text_in(body, "key");
    const std::string text = text_in(body, "text");
    const Field* field = parameters::field_of(key);
    if (field == nullptr || !std::holds_alternative<Quantity>(field->kind))
        throw Error(ErrorKind::input, {"\"key\" must name a quantity", "", "GET /api/start lists them."});
    if (text.size() > longest_value)
        throw Error(ErrorKind::input, {key + ": the text is too long for a number", "", ""});
    double number = 0.0;
    try {
        number = number_of(*field, text);
    } catch (const Error& error) {
        throw io::located(error, key, {});
    }
    return json(Json{{"schema", "stridor.explorer.value/1"}, {"value", number}}.dump());
}

Response share(const World& world, const Json& body, const std::stop_token&) {
    const Case c = case_in(world, body);
    if (parameters::is_of_file(c.drive))
        throw Error(ErrorKind::input, {"a sampled drive does not travel in a link",
                                       "its samples are in a file of this machine", "Send the case with that file."});
    if (!parameters::has_plate(c))
        throw Error(ErrorKind::input, {"a structure of its own does not travel in a link",
                                       "a link holds changes to a built-in case", "Send the case as a file."});
    if (!parameters::has_one_joint(c))
        throw Error(ErrorKind::input, {"several joints do not travel in a link",
                                       "a link holds changes to a built-in case", "Send the case as a file."});
    if (parameters::has_temperature_table(c))
        throw Error(ErrorKind::input, {"a table over temperature does not travel in a link",
                                       "a link holds one number for each quantity", "Send the case as a file."});
    const Preset& own = preset_named(world, text_in(body, "preset"));
    std::optional<Json> nearest;
    for (const Preset& preset : world.presets) {
        if (!preset.file.empty()) continue;  // others do not have it
        if (own.file.empty() && &preset != &own) continue;
        std::vector<std::string> set = changes(read_preset(preset, {}), c);
        if (nearest && (*nearest)["set"].size() <= set.size()) continue;
        // a link that says another case than the one it was made of would be worse than none
        if (parameters::canonical_text(read_preset(preset, set)) != parameters::canonical_text(c)) continue;
        nearest = Json{{"schema", "stridor.explorer.share/1"}, {"preset", preset.name}, {"set", std::move(set)}};
    }
    if (!nearest) throw Error(ErrorKind::input, {"this case fits into no link", "", "Copy it as TOML."});
    return json(nearest->dump());
}

}  // namespace stridor::explorer
