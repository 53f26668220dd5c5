#include "stridor/io/toml_case.hpp"

#include "stridor/base/text.hpp"
#include "stridor/parameters/check.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::io {

namespace {

using parameters::Case;
using parameters::Choice;
using parameters::Field;
using parameters::Quantity;

constexpr std::string_view chart_section = "chart";

bool is_chart_key(std::string_view key) {
    return key == chart_section || (key.starts_with(chart_section) && key[chart_section.size()] == '.');
}

std::vector<std::string_view> section_names() {
    std::vector<std::string_view> names;
    for (const Field& field : parameters::fields())
        if (!field.section.empty() && (names.empty() || names.back() != field.section)) names.push_back(field.section);
    names.push_back(chart_section);
    return names;
}

bool is_section(std::string_view key) {
    const std::vector<std::string_view> names = section_names();
    return std::find(names.begin(), names.end(), key) != names.end();
}

// a key in another section, or without any: "preload" is contact.preload
std::string same_name_elsewhere(std::string_view key) {
    const std::string_view name = key.substr(key.rfind('.') == std::string_view::npos ? 0 : key.rfind('.') + 1);
    for (const Field& field : parameters::fields())
        if (field.name == name) return parameters::key_of(field);
    return {};
}

Error unknown_key(const TomlEntry& entry) {
    const bool is_table = std::holds_alternative<TomlTable>(entry.value);
    const std::vector<std::string_view> sections = section_names();
    std::string near;
    if (is_table) {
        const std::string_view section = base::nearest_name(entry.key, sections);
        near = section.empty() ? "" : "[" + std::string(section) + "]";
    } else {
        near = parameters::nearest_key(entry.key);
        if (near.empty()) near = same_name_elsewhere(entry.key);
    }
    const std::string what = is_table ? "unknown section [" + entry.key + "]" : "unknown key " + entry.key;
    return {ErrorKind::input, {what, "", near.empty() ? "" : "Did you mean " + near + "?"}, entry.key_place};
}

void check_known(const TomlDocument& document) {
    for (const TomlEntry& entry : document.entries) {
        if (is_chart_key(entry.key)) continue;
        if (is_section(entry.key)) {
            if (std::holds_alternative<TomlTable>(entry.value)) continue;
            throw Error(ErrorKind::input,
                        {entry.key + " is " + std::string(type_name(entry.value)),
                         "expected a section: [" + entry.key + "] with its keys", ""},
                        entry.key_place);
        }
        if (parameters::find_field(entry.key) == nullptr) throw unknown_key(entry);
    }
}

std::string expected(const Field& field) {
    if (const auto* quantity = std::get_if<Quantity>(&field.kind))
        return quantity->unit == "1" ? std::string("expected a number")
                                     : "expected a number in " + std::string(quantity->unit) +
                                           ", or text with a unit such as \"1 " + std::string(quantity->unit) + "\"";
    std::string names;
    if (const auto* choice = std::get_if<Choice>(&field.kind))
        for (const std::string_view name : choice->names)
            names += (names.empty() ? "\"" : ", \"") + std::string(name) + "\"";
    return names.empty() ? std::string("expected text") : "expected one of " + names;
}

void assign(Case& c, const Field& field, const TomlEntry& entry) {
    try {
        if (const auto* text = std::get_if<std::string>(&entry.value))
            return parameters::set_from_text(c, field, *text);
        const auto* number = std::get_if<double>(&entry.value);
        const bool takes_number = std::holds_alternative<Quantity>(field.kind);
        if (number != nullptr && takes_number) return parameters::set_quantity(c, field, *number);
    } catch (const Error& error) {
        throw located(error, entry.key, entry.value_place);
    }
    throw Error(ErrorKind::input, {entry.key + " is " + std::string(type_name(entry.value)), expected(field), ""},
                entry.value_place);
}

enum class Pass { choices, the_rest };
enum class Layer { file, everything };

// choices first: they decide which other keys belong
void assign_all(Case& c, const TomlDocument& document, Pass pass, Layer layer) {
    for (const TomlEntry& entry : document.entries) {
        const Field* field = parameters::find_field(entry.key);
        if (field == nullptr || (layer == Layer::file && entry.origin != TomlOrigin::file)) continue;
        const bool is_choice = std::holds_alternative<Choice>(field->kind);
        const bool decides = layer == Layer::file || document.find(entry.key) == &entry;
        if (decides && is_choice == (pass == Pass::choices)) assign(c, *field, entry);
    }
}

void check_complete(const Case& c, const TomlDocument& document) {
    const bool knows_drive = document.find("drive.kind") != nullptr;
    std::string missing;
    int count = 0;
    for (const Field& field : parameters::fields()) {
        const std::string key = parameters::key_of(field);
        const bool is_known = field.section != "drive" || field.name == "kind" || knows_drive;
        if (!is_known || !is_required(field) || !field.belongs(c) || document.find(key) != nullptr) continue;
        missing += (count++ == 0 ? "" : ", ") + key;
    }
    if (count == 0) return;
    throw Error(ErrorKind::input,
                {(count == 1 ? "missing key " : "missing keys ") + missing,
                 count == 1 ? "it has no sensible default" : "they have no sensible defaults",
                 "`stridor init` prints complete cases to start from."},
                base::Place{document.name, 0, 0, ""});
}

// the choices that would give a key a meaning: drive.kind = "constant"
std::string where_it_belongs(const Case& c, const Field& field) {
    std::string homes;
    for (const Field& other : parameters::fields()) {
        const auto* choice = std::get_if<Choice>(&other.kind);
        if (choice == nullptr) continue;
        for (std::size_t index = 0; index < choice->names.size(); ++index) {
            Case changed = c;
            choice->set(changed, static_cast<int>(index));
            if (!field.belongs(changed)) continue;
            homes += (homes.empty() ? "" : " or ") + parameters::key_of(other) + " = \"" +
                     std::string(choice->names[index]) + "\"";
        }
    }
    return homes;
}

// a key of the file is held against the file's own choices, an override against those that count in the end
void check_belonging(const Case& of_file, const Case& c, const TomlDocument& document) {
    for (const TomlEntry& entry : document.entries) {
        const Field* field = parameters::find_field(entry.key);
        const Case& judge = entry.origin == TomlOrigin::file ? of_file : c;
        if (field == nullptr || field->belongs(judge)) continue;
        throw Error(ErrorKind::input,
                    {entry.key + " means nothing for this case", "it belongs to " + where_it_belongs(judge, *field),
                     "Remove it, or change the other key."},
                    entry.key_place);
    }
}

void read_samples(Case& c, const TomlDocument& document, const SamplesReader& samples) {
    if (c.drive.kind != parameters::DriveKind::sampled) return;
    const TomlEntry* entry = document.find("drive.file");
    const std::filesystem::path folder =
        entry->origin == TomlOrigin::file ? std::filesystem::path(document.name).parent_path() : "";
    try {
        SampledMotion motion = samples((folder / c.drive.file).string());
        c.drive.times = std::move(motion.times);
        c.drive.velocities = std::move(motion.velocities);
    } catch (const Error& error) {
        // what is wrong in the table has a place of its own there
        if (error.place()) throw;
        throw located(error, "drive.file", entry->value_place);
    }
}

void check_consistent(const Case& c, const TomlDocument& document) {
    const std::vector<parameters::Finding> found = parameters::findings(c);
    if (found.empty()) return;
    base::Problem problem = found.front().problem;
    for (std::size_t k = 1; k < found.size(); ++k)
        problem.suggestion += (problem.suggestion.empty() ? "Also: " : " Also: ") + found[k].problem.what + ".";
    const TomlEntry* entry = document.find(found.front().key);
    throw Error(ErrorKind::input, std::move(problem),
                entry != nullptr ? entry->value_place : base::Place{document.name, 0, 0, ""});
}

}  // namespace

bool is_required(const parameters::Field& field) {
    constexpr std::array<std::string_view, 4> sections{"joint", "plate", "contact", "drive"};
    return std::find(sections.begin(), sections.end(), field.section) != sections.end() &&
           parameters::key_of(field) != "contact.impact";
}

parameters::Case read_base_case(const TomlDocument& document, const SamplesReader& samples) {
    check_known(document);
    Case of_file;
    assign_all(of_file, document, Pass::choices, Layer::file);
    Case c;
    assign_all(c, document, Pass::choices, Layer::everything);
    check_complete(c, document);
    check_belonging(of_file, c, document);
    assign_all(c, document, Pass::the_rest, Layer::everything);
    // a window nobody wrote is the default one or the whole run, whichever is shorter
    if (document.find("run.window") == nullptr) c.run.window = std::min(c.run.window, c.run.duration);
    read_samples(c, document, samples);
    return c;
}

parameters::Case read_case(const TomlDocument& document, const SamplesReader& samples) {
    Case c = read_base_case(document, samples);
    check_consistent(c, document);
    return c;
}

parameters::Case read_case(const TomlSource& source) {
    return read_case(parse_toml(source), read_sampled_file);
}

parameters::Case read_case(const std::string& path, std::vector<std::string> overrides) {
    return read_case(load_toml(path, std::move(overrides)));
}

}  // namespace stridor::io
