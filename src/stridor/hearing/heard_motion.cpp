#include "stridor/hearing/heard_motion.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/sweep/evaluate.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::hearing {

namespace {

using parameters::Case;

constexpr std::string_view by_default = "joint";
constexpr std::size_t most_named = 12;  // contacts that a message lists
constexpr double equal = 1.0 + 1e-9;    // [1] of levels that differ by rounding

std::string listed_names(std::vector<std::string> names) {
    if (names.size() > most_named) {
        names.resize(most_named);
        names.emplace_back("...");
    }
    return base::listed(names);
}

HeardMotion motion_of_contact(const Case& c, std::size_t contact, const AskedMotion& asked) {
    const bool is_along = asked.component != "y";
    HeardMotion motion{{0, asked.quantity}, parameters::contact_name(c, contact), is_along ? "x" : "y", contact};
    if (!c.own_structure) {
        motion.pickup.dof = 2 * contact + (is_along ? 0U : 1U);
        return motion;
    }
    const parameters::OwnContact& own = c.own_structure->contacts[contact];
    motion.pickup.weights = is_along ? own.tangent : own.normal;
    return motion;
}

HeardMotion motion_of_plate(const AskedMotion& asked) {
    if (asked.component == "x")
        base::refuse("the plate's motion along x is imposed", "it is the drive, without any vibration",
                     "Listen to --component y of the plate, or to the joint.");
    return {{sound::last_dof, asked.quantity}, "plate", "y", {}};
}

void expect_one_direction(const AskedMotion& asked, std::string_view of) {
    if (asked.component.empty()) return;
    base::refuse("--component " + asked.component + " does not go with " + std::string(of), "it has one direction",
                 "Leave it out, or listen to a contact.");
}

const parameters::OwnOutput* find_output(const Case& c, const AskedMotion& asked) {
    if (!c.own_structure || c.own_structure->outputs.empty()) return nullptr;
    const std::vector<parameters::OwnOutput>& outputs = c.own_structure->outputs;
    if (asked.of == by_default) return &outputs.front();
    const auto found = std::find_if(outputs.begin(), outputs.end(),
                                    [&](const parameters::OwnOutput& output) { return output.name == asked.of; });
    return found == outputs.end() ? nullptr : &*found;
}

HeardMotion motion_of_output(const parameters::OwnOutput& output, const AskedMotion& asked) {
    expect_one_direction(asked, "an output");
    return {{0, asked.quantity, output.weights}, output.name, "", {}};
}

// none of its contacts: a row of an own structure
HeardMotion motion_of_row(const Case& c, const AskedMotion& asked) {
    const std::vector<std::string> names = classification::contact_names(c);
    const std::string unknown = "\"" + base::visible(asked.of) + "\" is ";
    if (!c.own_structure)
        base::refuse(unknown + "nothing that moves in this case", "",
                     names.size() > 1 ? "Listen to joint (the strongest), plate, " + base::listed(names) + "."
                                      : "Listen to joint or plate.");
    const std::vector<std::string>& rows = c.own_structure->row;
    const auto row = std::find(rows.begin(), rows.end(), asked.of);
    if (row == rows.end())
        base::refuse(unknown + "no contact, output or row of this structure", "",
                     "Listen to a contact: " + listed_names(names) + "; or to a row, as `--trace` names them.");
    expect_one_direction(asked, "a row");
    return {{static_cast<std::size_t>(row - rows.begin()), asked.quantity}, *row, "", {}};
}

const char* quantity_word(signal::MotionQuantity quantity) {
    return quantity == signal::MotionQuantity::velocity ? "velocity" : "acceleration";
}

std::string along(const std::string& component) {
    return component.empty() ? "" : " along " + component;
}

// nothing where the strongest of several contacts is asked for
std::optional<HeardMotion> named_motion(const Case& c, const AskedMotion& asked) {
    if (asked.of == "plate" && !c.own_structure) return motion_of_plate(asked);
    if (const parameters::OwnOutput* output = find_output(c, asked)) return motion_of_output(*output, asked);
    const std::vector<std::string> names = classification::contact_names(c);
    if (asked.of == by_default) return names.size() > 1 ? std::nullopt : std::optional(motion_of_contact(c, 0, asked));
    const auto contact = std::find(names.begin(), names.end(), asked.of);
    if (contact == names.end()) return motion_of_row(c, asked);
    return motion_of_contact(c, static_cast<std::size_t>(contact - names.begin()), asked);
}

}  // namespace

std::size_t strongest_contact(std::span<const record::Tally> phases) {
    std::size_t strongest = 0;
    double most = 0.0;  // [m/s]
    for (std::size_t contact = 0; !phases.empty() && contact < phases.front().contacts.size(); ++contact)
        for (const record::Tally& phase : phases) {
            const double rms = analysis::evidence(phase, contact).levels.joint.rms;
            // false where nothing was judged
            if (!(rms > most * equal)) continue;
            most = rms;
            strongest = contact;
        }
    return strongest;
}

HeardMotion heard_motion(const Case& c, const AskedMotion& asked, std::span<const record::Tally> phases) {
    const std::optional<HeardMotion> named = named_motion(c, asked);
    return named ? *named : motion_of_contact(c, strongest_contact(phases), asked);
}

std::optional<HeardMotion> heard_motion(const Case& c, const AskedMotion& asked, const std::stop_token& stop,
                                        integration::Workspace& workspace) {
    if (std::optional<HeardMotion> named = named_motion(c, asked)) return named;
    const std::optional<sweep::Attempt> run = sweep::attempt(c, {}, stop, workspace);
    if (!run) return std::nullopt;
    return heard_motion(c, asked, run->motion.record.phases);
}

HeardMotion heard_motion(const Case& c, const AskedMotion& asked, const std::stop_token& stop) {
    integration::Workspace workspace;
    std::optional<HeardMotion> motion = heard_motion(c, asked, stop, workspace);
    if (!motion) throw Error(ErrorKind::interrupted, {"stopped", "half a sound is not kept", ""});
    return std::move(*motion);
}

std::string motion_words(const HeardMotion& motion) {
    return motion.of + " " + quantity_word(motion.pickup.quantity) + along(motion.component);
}

std::string motion_words(const Case& c, const AskedMotion& asked) {
    if (const parameters::OwnOutput* output = find_output(c, asked))
        return output->name + " " + quantity_word(asked.quantity);
    const std::string component = !asked.component.empty() ? asked.component : asked.of == "plate" ? "y" : "x";
    const std::string what = quantity_word(asked.quantity) + along(component);
    if (asked.of != by_default) return asked.of + " " + what;
    return parameters::contact_count(c) > 1 ? what + " of the strongest contact"
                                            : parameters::contact_name(c, 0) + " " + what;
}

}  // namespace stridor::hearing
