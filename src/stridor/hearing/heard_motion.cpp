#include "stridor/hearing/heard_motion.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/sweep/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
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
    const auto axis = is_along ? parameters::PointAxis::sliding : parameters::PointAxis::normal;
    return {{asked.quantity, parameters::point_weights(c, contact, axis)},
            parameters::contact_name(c, contact),
            is_along ? "x" : "y",
            contact};
}

HeardMotion motion_of_plate(const Case& c, const AskedMotion& asked) {
    if (asked.component == "x")
        base::refuse("the plate's motion along x is imposed", "it is the drive, without any vibration",
                     "Listen to --component y of the plate, or to the joint.");
    const std::size_t plate = parameters::coordinate_count(c) - 1;
    return {{asked.quantity, parameters::weight_of_one(c, plate)}, "plate", "y", {}};
}

void expect_one_direction(const AskedMotion& asked, std::string_view of) {
    if (asked.component.empty()) return;
    base::refuse("--component " + asked.component + " does not go with " + std::string(of), "it has one direction",
                 "Leave it out, or listen to a contact.");
}

const parameters::OwnOutput* find_output(const Case& c, const AskedMotion& asked) {
    const std::span<const parameters::OwnOutput> outputs = parameters::outputs_of(c);
    if (asked.of == by_default) return outputs.empty() ? nullptr : &outputs.front();
    const auto found = std::find_if(outputs.begin(), outputs.end(),
                                    [&](const parameters::OwnOutput& output) { return output.name == asked.of; });
    return found == outputs.end() ? nullptr : &*found;
}

HeardMotion motion_of_output(const parameters::OwnOutput& output, const AskedMotion& asked) {
    expect_one_direction(asked, "an output");
    return {{asked.quantity, output.weights}, output.name, "", {}};
}

// none of its contacts: a row of an own structure
HeardMotion motion_of_row(const Case& c, const AskedMotion& asked) {
    const std::vector<std::string> names = classification::contact_names(c);
    const std::string unknown = "\"" + base::visible(asked.of) + "\" is ";
    if (parameters::has_plate(c))
        base::refuse(unknown + "nothing that moves in this case", "",
                     names.size() > 1 ? "Listen to joint (the strongest), plate, " + base::listed(names) + "."
                                      : "Listen to joint or plate.");
    const std::vector<std::string> rows = parameters::coordinate_names(c);
    const auto row = std::find(rows.begin(), rows.end(), asked.of);
    if (row == rows.end())
        base::refuse(unknown + "no contact, output or row of this structure", "",
                     "Listen to a contact: " + listed_names(names) + "; or to a row, as `--trace` names them.");
    expect_one_direction(asked, "a row");
    const auto coordinate = static_cast<std::size_t>(row - rows.begin());
    return {{asked.quantity, parameters::weight_of_one(c, coordinate)}, *row, "", {}};
}

const char* quantity_word(signal::MotionQuantity quantity) {
    return quantity == signal::MotionQuantity::velocity ? "velocity" : "acceleration";
}

std::string along(const std::string& component) {
    return component.empty() ? "" : " along " + component;
}

// nothing where the strongest of several contacts is asked for
std::optional<HeardMotion> named_motion(const Case& c, const AskedMotion& asked) {
    if (asked.of == "plate" && parameters::has_plate(c)) return motion_of_plate(c, asked);
    if (const parameters::OwnOutput* output = find_output(c, asked)) return motion_of_output(*output, asked);
    const std::vector<std::string> names = classification::contact_names(c);
    if (asked.of == by_default) return names.size() > 1 ? std::nullopt : std::optional(motion_of_contact(c, 0, asked));
    const auto contact = std::find(names.begin(), names.end(), asked.of);
    if (contact == names.end()) return motion_of_row(c, asked);
    return motion_of_contact(c, static_cast<std::size_t>(contact - names.begin()), asked);
}

constexpr double samples_a_cycle = 40.0;  // [1] of the highest free mode
constexpr double highest_rate = 1e6;      // [Hz]
constexpr double most_numbers = 1.6e7;    // [1] of all modes: 128 MB
constexpr double most_samples = 524288.0;
constexpr std::size_t least_frame = 64;
constexpr double frames = 4.0;  // [1] of a stretch: more smooth a spectrum, and blur its lines

Eigen::VectorXd weights_of(const sound::Pickup& pickup, Eigen::Index dofs) {
    STRIDOR_EXPECT(static_cast<Eigen::Index>(pickup.weights.size()) == dofs);
    return Eigen::Map<const Eigen::VectorXd>(pickup.weights.data(), dofs);
}

record::TraceRequest trace_of(const parameters::Case& c, const std::vector<double>& frequencies) {
    const double judged = c.run.window * (1.0 - c.verdict.start);
    const double highest = frequencies.empty() ? 0.0 : frequencies.back();
    const double rate = highest > 0.0 ? std::min(samples_a_cycle * highest, highest_rate) : 1e4 / judged;
    const double most =
        std::min(most_samples, most_numbers / static_cast<double>(std::max<std::size_t>(frequencies.size(), 1)));
    record::TraceRequest trace;
    trace.interval = 1.0 / rate;
    trace.to = c.run.duration;
    trace.from = std::max(c.run.duration - judged, c.run.duration - most / rate);
    return trace;
}

// takes the mean away, which is no vibration; what is left of a motion that has died out is none either
void keep_vibration(std::vector<std::vector<double>>& velocities) {
    for (std::vector<double>& velocity : velocities) {
        const double sum = std::accumulate(velocity.begin(), velocity.end(), 0.0);
        const double mean = velocity.empty() ? 0.0 : sum / static_cast<double>(velocity.size());
        for (double& value : velocity)
            value -= mean;
    }
    double most = 0.0;  // [m/s]
    for (std::size_t sample = 0; !velocities.empty() && sample < velocities.front().size(); ++sample) {
        double sum = 0.0;
        for (const std::vector<double>& velocity : velocities)
            sum += velocity[sample];
        most = std::max(most, std::abs(sum));
    }
    if (most > least_motion) return;
    for (std::vector<double>& velocity : velocities)
        std::fill(velocity.begin(), velocity.end(), 0.0);
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

HeardModes heard_modes(const parameters::Case& c, const AskedMotion& asked, const std::stop_token& stop) {
    if (asked.quantity != signal::MotionQuantity::velocity)
        base::refuse("the modes of an acceleration are not told apart", "the spectrum is of a velocity", "");
    const HeardMotion motion = heard_motion(c, asked, stop);
    const model::Structure structure = model::structure_of(c);
    HeardModes heard{motion_words(motion), analysis::open_modes(structure)};
    const Eigen::MatrixXd rows =
        analysis::modal_rows(heard.modes, structure.mass, weights_of(motion.pickup, structure.mass.rows()));
    std::vector<std::vector<double>> velocities(static_cast<std::size_t>(rows.rows()));
    record::Request request{record::KeepHistory::no, trace_of(c, heard.modes.frequencies)};
    request.trace.taker = [&](const record::Trace& trace) {
        Eigen::VectorXd velocity(rows.cols());
        for (std::size_t sample = 0; sample < trace.time.size(); ++sample) {
            for (Eigen::Index row = 0; row < velocity.size(); ++row)
                velocity(row) = trace.velocity[static_cast<std::size_t>(row)][sample];
            const Eigen::VectorXd parts = rows * velocity;
            for (std::size_t mode = 0; mode < velocities.size(); ++mode)
                velocities[mode].push_back(parts(static_cast<Eigen::Index>(mode)));
        }
    };
    const integration::Motion run = integration::simulate(c, request, stop);
    if (const std::optional<Error> failure = integration::failure(c, run)) throw *failure;
    keep_vibration(velocities);
    const double samples = velocities.empty() ? 0.0 : static_cast<double>(velocities.front().size());
    const auto size = std::max(least_frame, 2 * static_cast<std::size_t>(samples / (frames + 1.0)));
    heard.spectrum = analysis::modal_spectrum(velocities, 1.0 / request.trace.interval, size);
    heard.from = request.trace.from;
    heard.to = request.trace.to;
    return heard;
}

}  // namespace stridor::hearing
