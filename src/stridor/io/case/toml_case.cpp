#include "stridor/io/case/toml_case.hpp"

#include "stridor/base/text.hpp"
#include "stridor/io/case/complaints.hpp"
#include "stridor/io/case/own_structure/toml_structure.hpp"
#include "stridor/io/case/toml_case_keys.hpp"
#include "stridor/io/case/toml_joints.hpp"
#include "stridor/io/case/toml_temperature.hpp"
#include "stridor/parameters/check.hpp"
#include "stridor/parameters/joints.hpp"

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

enum class Pass { choices, the_rest };
enum class SettingLayer { file, everything };

// a list or table that stands for a value has complaints of its own for what is in it
bool has_inner(const TomlDocument& document, const TomlEntry& entry) {
    return std::holds_alternative<TomlTable>(entry.value) &&
           std::any_of(document.entries.begin(), document.entries.end(),
                       [&](const TomlEntry& other) { return other.key.starts_with(entry.key + "."); });
}

/// A document on its way to a case, with what is wrong with it so far.
class CaseReading {
public:
    /// `beginning` has what fields do not say: a structure of its own.
    explicit CaseReading(const TomlDocument& document, const Case& beginning = {})
        : document_(&document),
          of_file_(beginning),
          c_(beginning) {}

    /// Chooses the kinds, which decide what else belongs, and looks whether all keys are there and in their place.
    void read_kinds() {
        const std::vector<std::string> meant = check_known(*document_, complaints_);
        unread_.insert(unread_.end(), meant.begin(), meant.end());
        const std::vector<std::string> untold = read_temperature_table(*document_, c_, complaints_);
        unread_.insert(unread_.end(), untold.begin(), untold.end());
        of_file_.temperature = c_.temperature;
        assign_all(of_file_, Pass::choices, SettingLayer::file);
        assign_all(c_, Pass::choices, SettingLayer::everything);
        const std::vector<std::string> missing = check_complete(c_, *document_, unread_, complaints_);
        unread_.insert(unread_.end(), missing.begin(), missing.end());
        if (knows_kinds()) check_belonging(of_file_, c_, *document_, complaints_);
    }

    void read_values() {
        assign_all(c_, Pass::the_rest, SettingLayer::everything);
        // a window nobody wrote is the default one or the whole run, whichever is shorter
        if (document_->find("run.window") == nullptr) c_.run.window = std::min(c_.run.window, c_.run.duration);
    }

    /// What contradicts each other, as far as it is known.
    void check_findings() {
        for (const parameters::Finding& finding : parameters::findings(c_)) {
            if (!is_sound(finding)) continue;
            const TomlEntry* entry = document_->find(finding.key);
            if (entry == nullptr) entry = find_temperature_list(*document_, finding.key);
            complaints_.add({ErrorKind::input, finding.problem,
                             entry != nullptr ? entry->value_place : base::Place{document_->name, 0, 0, ""}});
        }
    }

    const Case& of_file() const { return of_file_; }
    Case& result() { return c_; }
    const Complaints& complaints() const { return complaints_; }

private:
    void assign_all(Case& c, Pass pass, SettingLayer layer) {
        for (const TomlEntry& entry : document_->entries) {
            const Field* field = parameters::find_field(entry.key);
            if (field == nullptr || (layer == SettingLayer::file && entry.origin != TomlOrigin::file)) continue;
            const bool is_choice = std::holds_alternative<Choice>(field->kind);
            const bool decides = layer == SettingLayer::file || document_->find(entry.key) == &entry;
            if (!decides || is_choice != (pass == Pass::choices)) continue;
            if (!has_inner(*document_, entry) && complaints_.keep([&] { assign(c, *field, entry); })) continue;
            unread_.push_back(entry.key);
            // what follows the temperature is not known without it
            if (field->section == "temperature")
                for (const parameters::TemperatureColumn& column : c.temperature.columns)
                    unread_.push_back(column.key);
        }
    }

    bool is_unread(std::string_view key) const {
        return std::find(unread_.begin(), unread_.end(), key) != unread_.end();
    }

    bool knows_kinds() const {
        return std::none_of(unread_.begin(), unread_.end(), [](const std::string& key) {
            const Field* field = parameters::find_field(key);
            return field != nullptr && std::holds_alternative<Choice>(field->kind);
        });
    }

    // does it rest on values that were read?
    bool is_sound(const parameters::Finding& finding) const {
        if (finding.others.empty()) return complaints_.empty();
        return !is_unread(finding.key) && std::none_of(finding.others.begin(), finding.others.end(),
                                                       [&](std::string_view key) { return is_unread(key); });
    }

    const TomlDocument* document_;
    Complaints complaints_;
    std::vector<std::string> unread_;  // keys whose values are not known
    Case of_file_;                     // the kinds that the file chooses
    Case c_;
};

void read_samples(Case& c, const TomlDocument& document, const SamplesReader& samples) {
    if (!parameters::is_of_file(c.drive)) return;
    const TomlEntry* entry = document.find("drive.file");
    const std::filesystem::path folder =
        entry->origin == TomlOrigin::file ? std::filesystem::path(document.name).parent_path() : "";
    try {
        recordings::SampledMotion motion = samples((folder / c.drive.file).string());
        c.drive.times = std::move(motion.times);
        c.drive.velocities = std::move(motion.velocities);
    } catch (const Error& error) {
        // what is wrong in the table has a place of its own there
        if (error.place()) throw;
        throw located(error, "drive.file", entry->value_place);
    }
}

// do the values have to fit together, or do axes replace some of them first?
enum class ReadAs { complete_case, base_of_chart };

parameters::Case read_one(const TomlDocument& document, const SamplesReader& samples, ReadAs what,
                          const Case& beginning = {}) {
    CaseReading reading(document, beginning);
    reading.read_kinds();
    reading.read_values();
    if (what == ReadAs::base_of_chart) reading.complaints().throw_any();
    // what a sampled drive moves is known only when its file is read
    if (reading.complaints().empty()) read_samples(reading.result(), document, samples);
    if (what == ReadAs::complete_case) reading.check_findings();
    reading.complaints().throw_any();
    return reading.result();
}

// several joints: the file is read once for each, and the first says what they share
parameters::Case read_several(const TomlDocument& document, const SamplesReader& samples, ReadAs what) {
    Complaints complaints;
    std::optional<Case> whole;
    for (const JointDocument& joint : joint_documents(document, complaints))
        complaints.keep([&] {
            const Case only = read_one(joint.document, samples, what);
            for (const parameters::Finding& finding : parameters::findings_among_several(only)) {
                const TomlEntry* entry = joint.document.find(finding.key);
                complaints.add({ErrorKind::input, finding.problem,
                                entry != nullptr ? entry->value_place : base::Place{document.name, 0, 0, ""}});
            }
            if (whole) return parameters::add_joint(*whole, joint.name, only);
            whole = only;
            whole->joint_name = joint.name;
        });
    complaints.throw_any();
    return *whole;
}

// a structure of its own stands where the joints would
parameters::Case read_with_structure(const TomlDocument& document, const CaseReaders& readers, ReadAs what) {
    Complaints complaints;
    const TomlDocument rest = without_structure(document, complaints);
    Case beginning;
    if (complaints.keep([&] { beginning.own_structure = readers.structure(document); }))
        complaints.keep([&] { beginning = read_one(rest, readers.samples, what, beginning); });
    complaints.throw_any();
    return beginning;
}

parameters::Case read_system(const TomlDocument& document, const CaseReaders& readers, ReadAs what) {
    if (has_own_structure(document)) return read_with_structure(document, readers, what);
    return lists_joints(document) ? read_several(document, readers.samples, what)
                                  : read_one(document, readers.samples, what);
}

}  // namespace

bool is_required(const parameters::Field& field) {
    constexpr std::array<std::string_view, 5> sections{"joint", "plate", "contact", "temperature", "drive"};
    const bool is_law = field.section == "contact" && std::holds_alternative<Choice>(field.kind);  // has a usual one
    return std::find(sections.begin(), sections.end(), field.section) != sections.end() && !is_law;
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

std::vector<base::Complaint> case_warnings(const TomlDocument& document) {
    Complaints names;  // said when the case is read
    std::vector<JointDocument> joints;
    // what is left over of one with a structure of its own is said when it is read
    if (has_own_structure(document)) return {};
    if (lists_joints(document)) joints = joint_documents(document, names);
    if (joints.empty()) joints.push_back({"", document});
    std::vector<base::Complaint> warnings;
    for (const JointDocument& joint : joints) {
        CaseReading reading(joint.document);
        reading.read_kinds();
        for (const TomlEntry& entry : joint.document.entries) {
            const Field* field = parameters::find_field(entry.key);
            if (field == nullptr || !is_idle(reading.of_file(), *field, entry)) continue;
            const bool is_told = std::any_of(warnings.begin(), warnings.end(), [&](const base::Complaint& told) {
                return told.place->line == entry.key_place.line && told.place->column == entry.key_place.column;
            });
            if (is_told) continue;
            warnings.push_back({{entry.key + " means nothing for this case and is left out",
                                 "it belongs to " + parameters::home_of(reading.of_file(), *field), ""},
                                entry.key_place});
        }
    }
    return warnings;
}

CaseReaders readers_without_files() {
    const SamplesReader none = [](const std::string&) -> recordings::SampledMotion {
        throw Error(ErrorKind::input,
                    {"drive.file is not opened here", "a case that came with a recording names no files", ""});
    };
    return {none, read_enclosed_structure};
}

parameters::Case read_base_case(const TomlDocument& document, const CaseReaders& readers) {
    return read_system(document, readers, ReadAs::base_of_chart);
}

parameters::Case read_case(const TomlDocument& document, const CaseReaders& readers) {
    return read_system(document, readers, ReadAs::complete_case);
}

parameters::Case read_case(const TomlSource& source) {
    return read_case(parse_toml(source));
}

parameters::Case read_case(const std::string& path, std::vector<std::string> overrides) {
    return read_case(load_toml(path, std::move(overrides)));
}

}  // namespace stridor::io
