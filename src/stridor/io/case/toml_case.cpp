#include "stridor/io/case/toml_case.hpp"

#include "stridor/base/text.hpp"
#include "stridor/io/case/complaints.hpp"
#include "stridor/io/case/own_structure/toml_structure.hpp"
#include "stridor/io/case/toml_case_keys.hpp"
#include "stridor/io/case/toml_joints.hpp"
#include "stridor/io/case/toml_temperature.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "stridor/parameters/tables/force_table.hpp"
#include "stridor/parameters/tables/friction_table.hpp"
#include "stridor/parameters/tables/material_pair.hpp"

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

/// A document on its way to a case, with what is wrong with it so far, for each joint.
class CaseReading {
public:
    /// `beginning` has what fields do not say: the names of its joints, a structure of its own.
    CaseReading(const TomlDocument& document, const Case& beginning)
        : document_(&document),
          complaints_(beginning.joints.size()),
          of_file_(beginning),
          c_(beginning) {}

    /// Chooses the kinds, which decide what else belongs, and looks whether all keys are there and in their place.
    void read_kinds() {
        for (std::size_t joint = 0; joint < joints(); ++joint)
            add_unread(check_known({*document_, joint}, complaints_[joint]), joint);
        Complaints of_table;
        for (Untold& untold : read_temperature_table(*document_, c_, of_table))
            unread_.push_back(std::move(untold));
        keep(std::nullopt, [&] { of_table.throw_any(); });
        of_file_.temperature = c_.temperature;
        assign_all(of_file_, Pass::choices, SettingLayer::file);
        assign_all(c_, Pass::choices, SettingLayer::everything);
        for (std::size_t joint = 0; joint < joints(); ++joint) {
            const DocumentView view(*document_, joint);
            add_unread(check_complete(c_, view, unread_of(joint), complaints_[joint]), joint);
            if (knows_kinds(joint)) check_belonging(of_file_, c_, view, complaints_[joint]);
        }
    }

    void read_values() {
        assign_all(c_, Pass::the_rest, SettingLayer::everything);
        // a window nobody wrote is the default one or the whole run, whichever is shorter
        if (document_->find("run.window") == nullptr) c_.run.window = std::min(c_.run.window, c_.run.duration);
    }

    /// What contradicts each other, as far as it is known.
    void check_findings() {
        for (std::size_t joint = 0; joint < joints(); ++joint)
            for (const parameters::Finding& finding : parameters::findings_at({c_, joint})) {
                if (!is_sound(finding, joint)) continue;
                const DocumentView view(*document_, joint);
                const TomlEntry* entry = view.find(finding.key);
                if (entry == nullptr) entry = find_temperature_list(view, finding.key);
                complaints_[joint].add(
                    {ErrorKind::input, finding.problem,
                     entry != nullptr ? entry->value_place : base::Place{document_->name, 0, 0, ""}});
            }
    }

    /// Is nothing wrong with one joint at least, and with what all share?
    bool has_sound_joint() const {
        return std::any_of(complaints_.begin(), complaints_.end(), [](const Complaints& of) { return of.empty(); });
    }

    void throw_any() const {
        Complaints all;
        for (const Complaints& of_joint : complaints_)
            all.keep([&] { of_joint.throw_any(); });
        all.throw_any();
    }

    const Case& of_file() const { return of_file_; }
    Case& result() { return c_; }

private:
    std::size_t joints() const { return complaints_.size(); }

    // does a part of the reading that is about one joint, or about what all share; did it end in no error?
    template <typename Part>
    bool keep(std::optional<std::size_t> joint, Part&& part) {
        Complaints own;
        const bool is_good = own.keep(std::forward<Part>(part));
        for (std::size_t k = 0; !is_good && k < joints(); ++k)
            if (!joint || *joint == k) complaints_[k].keep([&] { own.throw_any(); });
        return is_good;
    }

    void assign_all(Case& c, Pass pass, SettingLayer layer) {
        for (const TomlEntry& entry : document_->entries) {
            const Field* field = parameters::find_field(entry.key);
            if (field == nullptr || (layer == SettingLayer::file && entry.origin != TomlOrigin::file)) continue;
            if (std::holds_alternative<Choice>(field->kind) != (pass == Pass::choices)) continue;
            const std::size_t count = parameters::is_of_joint(*field) ? joints() : 1;
            for (std::size_t joint = 0; joint < count; ++joint)
                if (!entry.joint || *entry.joint == joint) assign_one({c, joint}, *field, entry, layer);
        }
    }

    void assign_one(parameters::CaseToSet at, const Field& field, const TomlEntry& entry, SettingLayer layer) {
        const bool decides = layer == SettingLayer::file || document_->find(entry.key, at.joint) == &entry;
        const auto joint = parameters::is_of_joint(field) ? std::optional(at.joint) : std::nullopt;
        if (!decides || (!has_inner(*document_, entry) && keep(joint, [&] { assign(at, field, entry); }))) return;
        unread_.push_back({entry.key, joint});
        // what follows the temperature is not known without it
        if (field.section == "temperature")
            for (const parameters::TemperatureColumn& column : at.c.temperature.columns) {
                const auto named = parameters::joint_key(column.key);
                unread_.push_back({named ? named->key : column.key, std::nullopt});
            }
    }

    void add_unread(const std::vector<std::string>& keys, std::size_t joint) {
        for (const std::string& key : keys)
            unread_.push_back({key, joint});
    }

    std::vector<std::string> unread_of(std::size_t joint) const {
        std::vector<std::string> keys;
        for (const Untold& untold : unread_)
            if (!untold.joint || *untold.joint == joint) keys.push_back(untold.key);
        return keys;
    }

    bool knows_kinds(std::size_t joint) const {
        const std::vector<std::string> unread = unread_of(joint);
        return std::none_of(unread.begin(), unread.end(), [](const std::string& key) {
            const Field* field = parameters::find_field(key);
            return field != nullptr && std::holds_alternative<Choice>(field->kind);
        });
    }

    // does it rest on values that were read?
    bool is_sound(const parameters::Finding& finding, std::size_t joint) const {
        if (finding.others.empty()) return complaints_[joint].empty();
        const std::vector<std::string> unread = unread_of(joint);
        return std::none_of(unread.begin(), unread.end(), [&](const std::string& key) {
            return key == finding.key ||
                   std::find(finding.others.begin(), finding.others.end(), key) != finding.others.end();
        });
    }

    const TomlDocument* document_;
    std::vector<Complaints> complaints_;  // shape [joint]; what is wrong with all of them stands with each
    std::vector<Untold> unread_;          // whose values are not known
    Case of_file_;                        // the kinds that the file chooses
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

// reads the rows of a joint's table from the file that its key names
template <typename Read>
void read_rows(const TomlDocument& document, std::string_view key, std::size_t joint, const std::string& file,
               const Read& read) {
    const TomlEntry* entry = document.find(key, joint);
    if (entry == nullptr) return;
    const std::filesystem::path folder =
        entry->origin == TomlOrigin::file ? std::filesystem::path(document.name).parent_path() : "";
    try {
        read((folder / file).string());
    } catch (const Error& error) {
        if (error.place()) throw;
        throw located(error, std::string(key), entry->value_place);
    }
}

// the tables of friction and of force that the case means; where the rows stand in it, no file is opened
void read_tables(Case& c, const TomlDocument& document, const CaseReaders& readers) {
    for (std::size_t joint = 0; joint < c.joints.size(); ++joint) {
        parameters::FrictionTable& friction = c.joints[joint].contact.friction_table;
        if (c.joints[joint].contact.friction == parameters::FrictionKind::table && friction.speeds.empty())
            read_rows(document, "contact.friction_table", joint, friction.file, [&](const std::string& path) {
                recordings::SampledFriction rows = readers.friction(path);
                friction.speeds = std::move(rows.speeds);
                friction.coefficients = std::move(rows.coefficients);
                parameters::expect_function(friction);
            });
        parameters::ForceTable& force = c.joints[joint].joint.axial_force;
        if (c.joints[joint].joint.stiffening == parameters::Stiffening::table && force.deflections.empty())
            read_rows(document, "joint.axial_force", joint, force.file, [&](const std::string& path) {
                recordings::SampledForce rows = readers.force(path);
                force.deflections = std::move(rows.deflections);
                force.forces = std::move(rows.forces);
                parameters::expect_rising(force);
            });
    }
}

// the pairs that the case names, which decide what else belongs to it: whether there is a humidity
void read_pairs(Case& c, const TomlDocument& document, const PairReader& read) {
    for (std::size_t joint = 0; joint < c.joints.size(); ++joint) {
        const TomlEntry* entry = document.find("contact.pair", joint);
        const auto* text = entry == nullptr ? nullptr : std::get_if<std::string>(&entry->value);
        if (text == nullptr) continue;
        const std::filesystem::path folder =
            entry->origin == TomlOrigin::file ? std::filesystem::path(document.name).parent_path() : "";
        try {
            parameters::MaterialPair pair = parameters::parse_material_pair(*text);
            if (pair.static_friction.empty() && !pair.source.empty()) {
                const parameters::NamedPair named = parameters::named_pair(*text);
                pair = read((folder / named.file).string(), named.name);
            }
            pair.source = *text;
            c.joints[joint].contact.pair = std::move(pair);
        } catch (const Error& error) {
            if (error.place()) throw;
            throw located(error, "contact.pair", entry->value_place);
        }
    }
    parameters::keep_pairs(c);
}

// do the values have to fit together, or do axes replace some of them first?
enum class ReadAs { complete_case, base_of_chart };

Case read_fields(const TomlDocument& fields, const CaseReaders& readers, ReadAs what, const Case& beginning) {
    Case begun = beginning;
    read_pairs(begun, fields, readers.pair);
    CaseReading reading(fields, begun);
    reading.read_kinds();
    reading.read_values();
    if (what == ReadAs::base_of_chart) reading.throw_any();
    // what a sampled drive moves is known only when its file is read
    if (reading.has_sound_joint()) {
        read_samples(reading.result(), fields, readers.samples);
        read_tables(reading.result(), fields, readers);
    }
    if (what == ReadAs::complete_case) reading.check_findings();
    reading.throw_any();
    return reading.result();
}

// which joints there are: their entries are taken from the document as those of one joint, and know whose they are
Case begin_joints(TomlDocument& document, Complaints& complaints) {
    JointsDocument joints = joints_document(document, complaints);
    document = std::move(joints.document);
    Case c;
    c.joints.resize(joints.names.size());
    for (std::size_t joint = 0; joint < joints.names.size(); ++joint)
        c.joints[joint].name = joints.names[joint];
    return c;
}

// whatever a case is made of, its fields are read in one way
Case read_system(const TomlDocument& document, const CaseReaders& readers, ReadAs what) {
    Complaints complaints;
    const bool has_own = has_own_structure(document);
    TomlDocument fields = has_own ? without_structure(document, complaints) : document;
    Case c;
    bool is_begun = true;
    if (has_own)
        is_begun = complaints.keep([&] { c.own_structure = readers.structure(document); });
    else if (lists_joints(document))
        c = begin_joints(fields, complaints);
    if (is_begun) complaints.keep([&] { c = read_fields(fields, readers, what, c); });
    complaints.throw_any();
    return c;
}

}  // namespace

bool is_required(const parameters::Field& field) {
    constexpr std::array<std::string_view, 5> sections{"joint", "plate", "contact", "temperature", "drive"};
    const bool is_law = (field.section == "contact" || field.section == "joint") &&
                        std::holds_alternative<Choice>(field.kind);  // has a usual one
    constexpr std::array<std::string_view, 5> usual{"stribeck_exponent", "viscous_friction", "bristle_damping",
                                                    "rest_exponent", "flexural_cubic"};
    const bool has_usual = std::find(usual.begin(), usual.end(), field.name) != usual.end();
    return std::find(sections.begin(), sections.end(), field.section) != sections.end() && !is_law && !has_usual &&
           !parameters::is_of_start(field);
}

void assign(parameters::CaseToSet at, const Field& field, const TomlEntry& entry) {
    try {
        if (const auto* text = std::get_if<std::string>(&entry.value))
            return parameters::set_from_text(at, field, *text);
        const auto* number = std::get_if<double>(&entry.value);
        const bool takes_number = std::holds_alternative<Quantity>(field.kind);
        if (number != nullptr && takes_number) return parameters::set_quantity(at, field, *number);
    } catch (const Error& error) {
        throw located(error, entry.key, entry.value_place);
    }
    throw Error(ErrorKind::input, {entry.key + " is " + std::string(type_name(entry.value)), expected(field), ""},
                entry.value_place);
}

std::vector<base::Complaint> case_warnings(const TomlDocument& document) {
    // what is left over of one with a structure of its own is said when it is read
    if (has_own_structure(document)) return {};
    Complaints names;  // said when the case is read
    TomlDocument fields = document;
    CaseReading reading(fields, lists_joints(document) ? begin_joints(fields, names) : Case());
    reading.read_kinds();
    std::vector<base::Complaint> warnings;
    for (const TomlEntry& entry : fields.entries) {
        const parameters::CaseView of_file(reading.of_file(), entry.joint.value_or(0));
        const Field* field = parameters::find_field(entry.key);
        if (field != nullptr && is_idle(of_file, *field, entry))
            warnings.push_back({{entry.key + " means nothing for this case and is left out",
                                 "it belongs to " + parameters::home_of(of_file, *field), ""},
                                entry.key_place});
    }
    return warnings;
}

CaseReaders readers_without_files() {
    const SamplesReader none = [](const std::string&) -> recordings::SampledMotion {
        throw Error(ErrorKind::input,
                    {"drive.file is not opened here", "a case that came with a recording names no files", ""});
    };
    const FrictionReader no_table = [](const std::string&) -> recordings::SampledFriction {
        throw Error(ErrorKind::input, {"contact.friction_table is no file here",
                                       "a case that came with a recording names no files", "Give its rows."});
    };
    const ForceReader no_force = [](const std::string&) -> recordings::SampledForce {
        throw Error(ErrorKind::input, {"joint.axial_force is no file here",
                                       "a case that came with a recording names no files", "Give its rows."});
    };
    const PairReader no_pair = [](const std::string&, const std::string&) -> parameters::MaterialPair {
        throw Error(ErrorKind::input, {"contact.pair names no file here",
                                       "a case that came with a recording names no files", "Give its rows."});
    };
    return {none, read_enclosed_structure, no_table, no_force, no_pair};
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
