#include "stridor/io/case/toml_case_keys.hpp"

#include "stridor/base/text.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_temperature.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/fields/field_name.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/tables/material_pair.hpp"
#include "stridor/sweep/ready_charts.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace stridor::io {

namespace {

using parameters::Case;
using parameters::Field;

constexpr std::string_view chart_section = "chart";
constexpr std::string_view document_section = "document";
constexpr std::array<std::string_view, 2> document_keys{"document.author", "document.part"};  // of a report

bool is_chart_key(std::string_view key) {
    return key == chart_section || (key.starts_with(chart_section) && key[chart_section.size()] == '.');
}

std::vector<std::string_view> section_names() {
    std::vector<std::string_view> names;
    for (const Field& field : parameters::fields())
        if (!field.section.empty() && (names.empty() || names.back() != field.section)) names.push_back(field.section);
    names.push_back(chart_section);
    names.push_back(document_section);
    return names;
}

bool is_section(std::string_view key) {
    const std::vector<std::string_view> names = section_names();
    return std::find(names.begin(), names.end(), key) != names.end();
}

bool contains(const std::vector<std::string>& keys, const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

Error unknown(const TomlEntry& entry, const std::string& what, const std::string& near) {
    return {ErrorKind::input, {what, "", near.empty() ? "" : "Did you mean " + near + "?"}, entry.key_place};
}

// an unknown section with all its keys; they are meant to stand in the section whose name is near
void refuse_section(const TomlDocument& document, const TomlEntry& section, std::vector<std::string>& meant,
                    Complaints& complaints) {
    const std::string near(base::nearest_name(section.key, section_names()));
    complaints.add(unknown(section, "unknown section [" + section.key + "]", near.empty() ? "" : "[" + near + "]"));
    const std::string prefix = section.key + ".";
    for (const TomlEntry& entry : document.entries)
        if (entry.key.starts_with(prefix)) meant.push_back(near + "." + entry.key.substr(prefix.size()));
}

bool is_in_unknown_section(const TomlDocument& document, const TomlEntry& entry) {
    const std::size_t point = entry.key.find('.');
    if (entry.origin != TomlOrigin::file || point == std::string::npos) return false;
    const std::string section = entry.key.substr(0, point);
    const TomlEntry* opened = document.find(section);
    return !is_section(section) && opened != nullptr && std::holds_alternative<TomlTable>(opened->value);
}

Error missing_keys(parameters::CaseView at, const TomlDocument& document, const std::vector<std::string>& missing) {
    std::string keys;
    std::string examples;
    for (const std::string& key : missing) {
        const Field& field = *parameters::find_field(key);
        keys += (keys.empty() ? "" : ", ") + key;
        examples += (examples.empty() ? "" : ", ") + toml_line(at, field) + " in [" + std::string(field.section) + "]";
    }
    const bool is_one = missing.size() == 1;
    return {ErrorKind::input,
            {(is_one ? "missing key " : "missing keys ") + keys,
             is_one ? "it has no sensible default" : "they have no sensible defaults",
             missing.size() <= 3 ? "Write for example " + examples + "."
                                 : "`stridor init` prints complete cases to start from."},
            base::Place{document.name, 0, 0, ""}};
}

// the values with which `stridor init` lets a case begin
std::vector<Case> cases_to_start_from() {
    std::vector<Case> cases(1);
    for (std::size_t k = 0; k < parameters::paper_case_names.size(); ++k)
        cases.push_back(parameters::paper_case(static_cast<parameters::PaperCase>(k)));
    for (std::size_t k = 0; k < sweep::soft_part_names.size(); ++k)
        cases.push_back(sweep::soft_part(static_cast<sweep::SoftPart>(k)).base);
    return cases;
}

}  // namespace

std::vector<std::string> check_known(const DocumentView& view, Complaints& complaints) {
    const TomlDocument& document = view.document;
    std::vector<std::string> meant;
    for (const TomlEntry& entry : document.entries) {
        if (!view.has(entry)) continue;
        const bool is_read_elsewhere = is_chart_key(entry.key) || is_temperature_list(entry.key);
        if (is_read_elsewhere || is_in_unknown_section(document, entry)) continue;
        if (std::find(document_keys.begin(), document_keys.end(), entry.key) != document_keys.end()) {
            if (!std::holds_alternative<std::string>(entry.value))
                complaints.add(
                    {ErrorKind::input,
                     {entry.key + " is " + std::string(type_name(entry.value)), "expected text", "Put it into quotes."},
                     entry.value_place});
            continue;
        }
        const bool is_table = std::holds_alternative<TomlTable>(entry.value);
        if (is_section(entry.key)) {
            if (is_table) continue;
            complaints.add({ErrorKind::input,
                            {entry.key + " is " + std::string(type_name(entry.value)),
                             "expected a section: [" + entry.key + "] with its keys", ""},
                            entry.key_place});
        } else if (is_table && parameters::find_field(entry.key) == nullptr) {
            refuse_section(document, entry, meant, complaints);
        } else if (parameters::find_field(entry.key) == nullptr) {
            meant.push_back(parameters::similar_key(entry.key));
            complaints.add(unknown(entry, "unknown key " + entry.key, meant.back()));
        }
    }
    return meant;
}

std::vector<std::string> check_complete(const Case& c, const DocumentView& view, const std::vector<std::string>& unread,
                                        Complaints& complaints) {
    const parameters::CaseView at(c, view.joint);
    const bool knows_drive = view.find("drive.kind") != nullptr && !contains(unread, "drive.kind");
    std::vector<std::string> missing;
    for (const Field& field : parameters::fields()) {
        const std::string key = parameters::key_of(field);
        const bool is_known = field.section != "drive" || field.name == "kind" || knows_drive;
        const bool is_needed =
            is_known && is_required(field) && field.belongs(at) && !parameters::follows_table(at, field);
        if (is_needed && view.find(key) == nullptr && !contains(unread, key)) missing.push_back(key);
    }
    if (!missing.empty()) complaints.add(missing_keys(at, view.document, missing));
    return missing;
}

bool is_idle(parameters::CaseView of_file, const Field& field, const TomlEntry& entry) {
    if (entry.origin != TomlOrigin::file || field.belongs(of_file)) return false;
    if (parameters::home_of(of_file, field).empty()) return false;  // no kind was changed
    Case written;
    try {
        assign(written, field, entry);
    } catch (const Error&) {
        return false;
    }
    const std::vector<Case> cases = cases_to_start_from();
    return std::any_of(cases.begin(), cases.end(), [&](const Case& start) {
        return parameters::value_text(start, field) == parameters::value_text(written, field);
    });
}

namespace {

// no choice gives it one: it is the structure that does not have it
Error without_meaning(const Field& field, const TomlEntry& entry) {
    if (field.section == "structure")
        return {ErrorKind::input,
                {entry.key + " means nothing for this case", "its joints stand on a plate",
                 "It belongs to a case with [structure]."},
                entry.key_place};
    const bool is_preload = field.name == "preload";
    return {
        ErrorKind::input,
        {entry.key + " means nothing for this structure",
         is_preload ? "a load or negative gaps press it" : "all of its contacts have one of their own", "Remove it."},
        entry.key_place};
}

}  // namespace

void check_belonging(const Case& of_file, const Case& c, const DocumentView& view, Complaints& complaints) {
    const TomlDocument& document = view.document;
    for (const TomlEntry& entry : document.entries) {
        if (!view.has(entry)) continue;
        const Field* field = parameters::find_field(entry.key);
        const parameters::CaseView judge(entry.origin == TomlOrigin::file ? of_file : c, view.joint);
        if (field == nullptr || field->belongs(judge) || is_idle({of_file, view.joint}, *field, entry)) continue;
        const std::string home = parameters::home_of(judge, *field);
        if (home.empty() && (judge.c.own_structure || field->section == "structure")) {
            complaints.add(without_meaning(*field, entry));
            continue;
        }
        if (home.empty() && has_temperature_list(document)) continue;  // a table that has complaints of its own
        complaints.add({ErrorKind::input,
                        {entry.key + " means nothing for this case",
                         !home.empty()                     ? "it belongs to " + home
                         : field->section == "temperature" ? std::string("nothing follows the temperature")
                                                           : std::string("no pair of materials depends on it"),
                         !home.empty() ? "Remove it, or change the other key."
                         : field->section == "temperature"
                             ? "Give [temperature] a table: at = [...] and, for example, axial_stiffness = [...]."
                             : "Remove it, or give contact.pair such a pair."},
                        entry.key_place});
    }
}

}  // namespace stridor::io
