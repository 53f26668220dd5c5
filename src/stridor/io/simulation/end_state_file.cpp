#include "stridor/io/simulation/end_state_file.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/hash.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/model/contact_state.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

namespace stridor::io {

namespace {

using namespace json_parts;
using integration::EndState;

constexpr std::size_t longest_end_state = 256'000'000;      // [bytes] 300 contacts in a plane need a tenth of it
constexpr const char* friction_member = "friction_states";  // where a law has one
constexpr std::string_view end_state_schema = "stridor.end-state/1";

// the members that the checksum is of, as text without blanks
std::string checked_text(const Json& document) {
    Json checked = Json::object();
    for (const char* member : {"case", "time", "displacement", "velocity", "contacts", "memory"})
        checked[member] = document.contains(member) ? document[member] : Json();
    if (document.contains("rested")) checked["rested"] = document["rested"];
    if (document.contains(friction_member)) checked[friction_member] = document[friction_member];
    return checked.dump(-1, ' ', false, Json::error_handler_t::replace);
}

[[noreturn]] void refuse_end_state(const std::string& name, std::string why) {
    throw Error(ErrorKind::input, {"this is no end state of a run", std::move(why), "Make it anew with --end-state."},
                base::Place{name, 0, 0, ""});
}

// a list of finite numbers
std::vector<double> numbers_in(const Json& list, const std::string& name, const std::string& member) {
    if (!list.is_array()) refuse_end_state(name, member + " is no list");
    std::vector<double> numbers;
    for (const Json& each : list) {
        if (!each.is_number() || !std::isfinite(each.get<double>()))
            refuse_end_state(name, member + " holds something that is no number");
        numbers.push_back(each.get<double>());
    }
    return numbers;
}

std::vector<model::ContactState> states_in(const Json& list, const std::string& name) {
    if (!list.is_array()) refuse_end_state(name, "contacts is no list");
    std::vector<model::ContactState> states;
    const auto& words = model::contact_state_names;
    for (const Json& each : list) {
        const auto* word = each.get_ptr<const std::string*>();
        const auto found = word == nullptr ? words.end() : std::find(words.begin(), words.end(), *word);
        if (found == words.end()) refuse_end_state(name, "contacts holds a word that is no contact state");
        states.push_back(static_cast<model::ContactState>(found - words.begin()));
    }
    return states;
}

std::string shape_text(std::size_t dofs, std::size_t contacts) {
    return std::to_string(dofs) + " degrees of freedom and " + std::to_string(contacts) +
           (contacts == 1 ? " contact" : " contacts");
}

}  // namespace

std::string case_to_go_on(const parameters::Case& c) {
    std::istringstream lines(parameters::canonical_text(c));
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        const bool is_told = line.starts_with("run.duration ") || line.starts_with("run.window ") ||
                             line.starts_with("run.early_ending ") || line.starts_with("verdict.");
        if (!is_told) text += line + "\n";
    }
    return base::hash_text(text);
}

std::string end_state_json(const parameters::Case& c, const EndState& state) {
    Json document = opening("end-state");
    document["case"] = case_to_go_on(c);
    document["time"] = state.time;
    document["displacement"] = state.displacement;
    document["velocity"] = state.velocity;
    document["contacts"] = array_of(state.contacts, [](model::ContactState contact) {
        return Json(model::contact_state_names[model::index_of(contact)]);
    });
    if (!state.friction_states.empty()) document[friction_member] = state.friction_states;
    document["memory"] = state.memory;
    document["units"] = {{"time", "s"}, {"displacement", "m"}, {"velocity", "m/s"}};
    if (!state.rested.empty()) {
        document["rested"] = state.rested;
        document["units"]["rested"] = "s";
    }
    document["checksum"] = base::sha256_text(checked_text(document));
    return base::text_of(document);
}

ReadEndState read_end_state(std::string_view text, const std::string& name) {
    if (text.size() > longest_end_state)
        refuse_end_state(name, "it is longer than " + std::to_string(longest_end_state / 1'000'000) + " MB");
    const Json document = base::foreign_document(text);
    if (document.is_discarded() || !document.is_object()) refuse_end_state(name, "it is no JSON document");
    if (document.value("schema", Json()) != Json(end_state_schema))
        refuse_end_state(name, "its schema is not \"" + std::string(end_state_schema) + "\"");
    for (const char* member : {"case", "time", "displacement", "velocity", "contacts", "memory", "checksum"})
        if (!document.contains(member)) refuse_end_state(name, "it has no " + std::string(member));
    if (document["checksum"] != Json(base::sha256_text(checked_text(document))))
        refuse_end_state(name, "it was changed since it was written: its checksum is another");
    ReadEndState read;
    const Json& time = document["time"];
    if (!time.is_number() || !std::isfinite(time.get<double>()) || !(time.get<double>() > 0.0))
        refuse_end_state(name, "its time is no positive number");
    if (!document["case"].is_string()) refuse_end_state(name, "its case is no text");
    read.case_hash = document["case"].get<std::string>();
    read.state.time = time.get<double>();
    read.state.displacement = numbers_in(document["displacement"], name, "displacement");
    read.state.velocity = numbers_in(document["velocity"], name, "velocity");
    read.state.contacts = states_in(document["contacts"], name);
    if (document.contains("rested")) {
        read.state.rested = numbers_in(document["rested"], name, "rested");
        const auto is_time = [](double rested) { return rested >= 0.0; };
        if (read.state.rested.size() != read.state.contacts.size() ||
            !std::all_of(read.state.rested.begin(), read.state.rested.end(), is_time))
            refuse_end_state(name, "rested is no time for each contact");
    }
    if (document.contains(friction_member)) {
        read.state.friction_states = numbers_in(document[friction_member], name, friction_member);
        if (read.state.friction_states.size() != read.state.contacts.size())
            refuse_end_state(name, "it has more friction states than contacts, or fewer");
    }
    if (read.state.displacement.size() != read.state.velocity.size())
        refuse_end_state(name, "it has more displacements than velocities, or fewer");
    if (!document["memory"].is_array()) refuse_end_state(name, "memory is no list");
    for (const Json& each : document["memory"])
        read.state.memory.push_back(numbers_in(each, name, "memory"));
    return read;
}

ReadEndState read_end_state_file(const std::string& path) {
    return read_end_state(storage::read_file(path), path);
}

void expect_same_case(const ReadEndState& read, const parameters::Case& c, const std::string& name) {
    expect_same_shape(read, c, name);
    if (read.case_hash == case_to_go_on(c)) return;
    throw Error(ErrorKind::input,
                {"the end state is of another case",
                 "a run goes on with the same system, drive, start and engine; only duration, window and thresholds "
                 "may be others",
                 "To begin another run in that state, use --initial."},
                base::Place{name, 0, 0, ""});
}

void expect_same_shape(const ReadEndState& read, const parameters::Case& c, const std::string& name) {
    const std::size_t dofs = parameters::coordinate_count(c), contacts = parameters::contact_count(c);
    if (read.state.displacement.size() == dofs && read.state.contacts.size() == contacts) return;
    throw Error(ErrorKind::input,
                {"the end state is of another system",
                 "it has " + shape_text(read.state.displacement.size(), read.state.contacts.size()) + ", the case " +
                     shape_text(dofs, contacts),
                 "Name the case that it was made with."},
                base::Place{name, 0, 0, ""});
}

}  // namespace stridor::io
