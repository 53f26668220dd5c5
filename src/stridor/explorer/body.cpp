#include "stridor/explorer/body.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/integration/cost.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/sweep/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::explorer {

namespace {

constexpr int most_overrides = 200;
constexpr std::size_t deepest_body = 16;  // levels of a request; the deepest has four

[[noreturn]] void refuse_request(const std::string& what, const std::string& why) {
    throw Error(ErrorKind::input, {what, why, ""});
}

const Json* member(const Json& object, const std::string& name, bool may_be_missing) {
    const auto found = object.find(name);
    if (found != object.end() && !found->is_null()) return &*found;
    if (!may_be_missing) refuse_request("\"" + name + "\" is missing in the request", "");
    return nullptr;
}

// a number of a builder that did not make this structure would be passed over
void expect_builders_number(const Preset& preset, const std::string& item) {
    const parameters::Field* field = parameters::find_field(io::parse_override(item).key);
    if (field == nullptr || !parameters::is_of_builder(*field)) return;
    const auto& structure = preset.structure;
    if (structure && structure->recipe && structure->recipe->numbers.contains(field->name)) return;
    refuse_request(parameters::key_of(*field) + " means nothing for this case",
                   "no builder made its structure from it");
}

// a request's overrides come after those that the program was started with
io::TomlDocument document_in(const Preset& preset, const Json& body) {
    io::TomlSource source = source_of(preset);
    for (std::string& item : overrides_in(body)) {
        expect_builders_number(preset, item);
        source.overrides.push_back(std::move(item));
    }
    return io::parse_toml(source);
}

const Preset& preset_in(const World& world, const Json& body) {
    return preset_named(world, text_in(body, "preset"));
}

// a slow structure may take minutes of its time, and little of ours
bool is_slow_enough(const parameters::Case& c) {
    constexpr double most = 5.0;  // [s] of one core
    return !parameters::has_plate(c) && integration::cost(c).seconds <= most;
}

void limit_run(const parameters::Case& c) {
    if (c.run.duration > longest_run && !is_slow_enough(c))
        throw Error(ErrorKind::input,
                    {"run.duration = " + base::shortest(c.run.duration) + " s is too long to be explored",
                     "at most " + base::shortest(longest_run) + " s are run at a time",
                     "Run it on the command line: stridor simulate."});
}

sweep::Axis axis_in(const Json& chart, const std::string& name) {
    const Json& axis = object_in(chart, name);
    const std::string scale = text_in(axis, "scale", "linear");
    const auto found = std::find(sweep::scale_names.begin(), sweep::scale_names.end(), scale);
    if (found == sweep::scale_names.end()) refuse_request("\"" + scale + "\" is no scale", "it is linear or log");
    const int points = whole_in(axis, "points", 64);
    if (points > most_chart_points)
        refuse_request(name + ": " + std::to_string(points) + " points are too many to be explored",
                       "at most " + std::to_string(most_chart_points) + " along each axis");
    return {text_in(axis, "parameter"), number_in(axis, "from"), number_in(axis, "to"), points,
            static_cast<sweep::Scale>(found - sweep::scale_names.begin())};
}

}  // namespace

Json parse_body(const std::string& text) {
    // copying or destroying a deep document takes the stack
    if (base::nesting(text) > deepest_body) refuse_request("the request nests too deep", "");
    Json body = Json::parse(text, nullptr, false);
    if (body.is_discarded() || !body.is_object()) refuse_request("the request is no JSON object", "");
    return body;
}

std::string text_in(const Json& object, const std::string& name, std::optional<std::string> otherwise) {
    const Json* value = member(object, name, otherwise.has_value());
    if (value == nullptr) return *otherwise;
    if (!value->is_string()) refuse_request("\"" + name + "\" must be text", "");
    return value->get<std::string>();
}

double number_in(const Json& object, const std::string& name, std::optional<double> otherwise) {
    const Json* value = member(object, name, otherwise.has_value());
    if (value == nullptr) return *otherwise;
    if (!value->is_number()) refuse_request("\"" + name + "\" must be a number", "");
    return value->get<double>();
}

int whole_in(const Json& object, const std::string& name, std::optional<int> otherwise) {
    const Json* value = member(object, name, otherwise.has_value());
    if (value == nullptr) return *otherwise;
    const double number = number_in(object, name);
    if (!(std::abs(number) <= 1e9) || number != std::floor(number))
        refuse_request("\"" + name + "\" must be a whole number", "");
    return static_cast<int>(number);
}

bool flag_in(const Json& object, const std::string& name) {
    const Json* value = member(object, name, true);
    if (value == nullptr) return false;
    if (!value->is_boolean()) refuse_request("\"" + name + "\" must be true or false", "");
    return value->get<bool>();
}

const Json& object_in(const Json& object, const std::string& name) {
    const Json* value = member(object, name, false);
    if (!value->is_object()) refuse_request("\"" + name + "\" must be an object", "");
    return *value;
}

std::vector<std::string> overrides_in(const Json& body) {
    const Json* set = member(body, "set", true);
    if (set == nullptr) return {};
    if (!set->is_array() || set->size() > most_overrides)
        refuse_request("\"set\" must be a list of at most " + std::to_string(most_overrides) + " texts", "");
    std::vector<std::string> overrides;
    for (const Json& item : *set) {
        if (!item.is_string()) refuse_request("\"set\" must be a list of texts like \"contact.preload=20\"", "");
        const std::string text = item.get<std::string>();
        const std::string key = io::parse_override(text).key;
        const parameters::Field* field = parameters::find_field(key);
        // what else stands in [structure] is the file's: matrices, their files, contacts, counts of a builder
        const bool is_of_structure = key == "structure" || key.starts_with("structure.");
        if (is_of_structure && field == nullptr)
            refuse_request(base::visible(key) + " cannot be set here", "the explorer opens no files on request");
        if (field != nullptr && parameters::names_file(*field))
            refuse_request(parameters::key_of(*field) + " cannot be set here",
                           "the explorer opens no files on request");
        const auto* numbers = field == nullptr ? nullptr : std::get_if<parameters::Text>(&field->kind);
        const bool is_file =
            numbers != nullptr && numbers->means == parameters::Text::Means::numbers &&
            text.substr(text.find('=') + 1).find(key == "contact.pair" ? ';' : ':') == std::string::npos;
        if (is_file)
            refuse_request(parameters::key_of(*field) + " takes rows here, no file",
                           "the explorer opens no files on request");
        overrides.push_back(text);
    }
    return overrides;
}

parameters::Case case_in(const World& world, const Json& body) {
    const Preset& preset = preset_in(world, body);
    parameters::Case c = io::read_case(document_in(preset, body), readers_of(preset));
    limit_run(c);
    return c;
}

sweep::Study study_in(const World& world, const Json& body) {
    const Json& chart = object_in(body, "chart");
    const Preset& preset = preset_in(world, body);
    sweep::Study study;
    study.base = io::read_base_case(document_in(preset, body), readers_of(preset));
    limit_run(study.base);
    study.x = axis_in(chart, "x");
    study.y = axis_in(chart, "y");
    study.refine = sweep::sound_refinement(study, whole_in(chart, "refine", 0));
    study.quantities = {text_in(body, "figure", "category")};
    sweep::check(study);
    return study;
}

Json default_chart() {
    return {
        {"x", {{"parameter", "contact.preload"}, {"from", 1.0}, {"to", 80.0}, {"points", 64}, {"scale", "linear"}}},
        {"y",
         {{"parameter", "contact.kinetic_friction"}, {"from", 0.0}, {"to", 0.8}, {"points", 64}, {"scale", "linear"}}},
        {"refine", 3}};
}

Json chart_of(const sweep::Study& study) {
    const auto axis = [](const sweep::Axis& a) {
        return Json{{"parameter", a.parameter},
                    {"from", a.from},
                    {"to", a.to},
                    {"points", std::min(a.points, most_chart_points)},
                    {"scale", sweep::scale_names[static_cast<std::size_t>(a.scale)]}};
    };
    return {{"x", axis(study.x)}, {"y", axis(study.y)}, {"figure", study.quantities.front()}};
}

}  // namespace stridor::explorer
