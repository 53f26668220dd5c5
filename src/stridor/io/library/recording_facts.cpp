#include "stridor/io/library/recording_facts.hpp"

#include "stridor/base/error.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/noise_library/entry_filler.hpp"
#include "stridor/parameters/case_key.hpp"
#include "stridor/parameters/joints.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::io {

namespace {

using noise_library::Entry;
using Metadata = std::vector<std::pair<std::string, std::string>>;

constexpr std::string_view simulated = "simulated by stridor";

bool is_id_line(const std::string& key) {
    return key.size() == 3 && key.starts_with("id") && key[2] >= '1' && key[2] <= '5';
}

std::string value_of(const Metadata& metadata, std::string_view key) {
    for (const auto& [name, value] : metadata)
        if (name == key) return value;
    return "";
}

bool is_simulated(const Metadata& metadata) {
    for (const char* key : {"description", "comment"})
        if (value_of(metadata, key).starts_with(simulated)) return true;
    return value_of(metadata, "origin") == "simulation" || value_of(metadata, "schema") == "stridor.trace/1";
}

// a trace tells each key of its case as a line; of several joints each begins with its name
std::string case_of_trace(const Metadata& metadata) {
    TomlSource source{"", "the trace", {}};
    std::vector<std::string> joints;
    for (const auto& [key, value] : metadata) {
        const std::optional<parameters::JointKey> of_joint = parameters::joint_key(key);
        const bool is_name = of_joint && parameters::names_a_joint(of_joint->joint);
        if (is_name && std::find(joints.begin(), joints.end(), of_joint->joint) == joints.end()) {
            joints.push_back(of_joint->joint);
            source.text += "[[joint]]\nname = \"" + of_joint->joint + "\"\n";
        }
        if (key.find('.') != std::string::npos) source.overrides.push_back(key + "=" + value);
        if (key == "title") source.overrides.push_back("title=" + value);
    }
    try {
        return case_toml(read_case(parse_toml(source), readers_without_files()), {Comments::none, ""});
    } catch (const Error&) {
        return "";
    }
}

// preload and motion as the case has them
void take_case(Entry& entry, const Notes& note) {
    parameters::Case c;
    try {
        c = read_case(parse_toml({entry.case_text, "the case", {}}), readers_without_files());
    } catch (const Error&) {
        note("the case that came with " + entry.file + " cannot be simulated by this program; it is kept");
        return;
    }
    noise_library::EntryFiller filler(entry);
    // of several joints that differ there is no one preload
    if (parameters::has_one_value(c, "contact.preload")) filler.take("preload", c.contact.preload);
    filler.take("velocity", noise_library::peak_velocity(c.drive));
    filler.take("velocity_profile", noise_library::profile_of(c.drive));
    for (const std::string& sentence : filler.notes(entry.file + " is a simulation; its case"))
        note(sentence);
}

void expect_simulation(Entry& entry) {
    if (!entry.recorded.empty() && entry.recorded != "simulation")
        throw Error(ErrorKind::input,
                    {entry.file + " was not recorded in a " + entry.recorded + " but simulated",
                     "it says so itself, and a library that mixes the two proves nothing", "Leave --recorded out."});
    entry.recorded = "simulation";
}

}  // namespace

void take_facts(const recordings::SignalFacts& facts, Entry& entry, const Notes& note) {
    const bool is_simulation = is_simulated(facts.metadata);
    if (is_simulation) {
        const bool is_said = !entry.recorded.empty();
        expect_simulation(entry);
        if (entry.case_text.empty()) entry.case_text = value_of(facts.metadata, "case");
        if (entry.case_text.empty()) entry.case_text = case_of_trace(facts.metadata);
        if (entry.case_text.empty() && !is_said) note(entry.file + " says it is a simulation");
    }
    // what a simulation is like is the case's to say
    if (!entry.case_text.empty() && entry.recorded == "simulation") take_case(entry, note);
    noise_library::EntryFiller filler(entry);
    for (const auto& [key, value] : facts.metadata)
        if (is_id_line(key))
            filler.take_line(value);
        else if (!recordings::calibration_in(value) && !value.starts_with(simulated))
            filler.take(key, value);
    for (const std::string& sentence : filler.notes(entry.file))
        note(sentence);
}

}  // namespace stridor::io
