#include "stridor/io/simulation/friction_test.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/parameters/case_key.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "stridor/recordings/rig_channels.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace stridor::io {

namespace {

using base::Json;

Json coefficient(const analysis::MeasuredCoefficient& c) {
    return {{"value", c.value}, {"uncertainty", c.uncertainty}, {"count", c.count}};
}

Json figures_object(const analysis::FrictionFigures& figures) {
    const char* direction = figures.direction == 0 ? "all" : figures.direction > 0 ? "going" : "coming";
    return {{"direction", direction},
            {"static_friction", coefficient(figures.static_friction)},
            {"kinetic_friction", coefficient(figures.kinetic_friction)},
            {"kinetic_source",
             json_parts::name_of<analysis::KineticSource>(analysis::kinetic_source_names, figures.source)},
            {"mean_friction", figures.mean_friction},
            {"moving_time", figures.moving_time},
            {"distance", figures.distance},
            {"drops", figures.drops},
            {"drop_rate", figures.drop_rate},
            {"mean_drop", figures.mean_drop},
            {"largest_drop", figures.largest_drop},
            {"interval_variation", figures.variation}};
}

}  // namespace

std::string friction_json(const FrictionTest& test, const analysis::FrictionTrace& trace) {
    Json document = {{"schema", "stridor.friction/1"}, {"version", base::version()}, {"commit", base::commit()}};
    document["test"] = {{"file", test.file},
                        {"channel", base::text_or_null(test.channel)},
                        {"velocity_channel", base::text_or_null(test.velocity_channel)},
                        {"normal_channel", base::text_or_null(test.normal_channel)},
                        {"rate", test.rate},
                        {"duration", test.duration},
                        {"preload", test.preload},
                        {"velocity", test.velocity},
                        {"condition", base::text_or_null(test.condition)}};
    document["all"] = figures_object(trace.all);
    document["directions"] = Json::array();
    for (const analysis::FrictionFigures& figures : trace.directions)
        document["directions"].push_back(figures_object(figures));
    document["drops"] = Json::array();
    for (const analysis::ForceDrop& drop : trace.drops)
        document["drops"].push_back({{"time", drop.time},
                                     {"duration", drop.duration},
                                     {"from", drop.from},
                                     {"to", drop.to},
                                     {"direction", drop.direction > 0 ? "going" : "coming"}});
    document["noise"] = trace.noise;
    document["threshold"] = trace.threshold;
    document["notes"] = trace.notes;
    document["units"] = {{"rate", "Hz"},
                         {"duration", "s"},
                         {"preload", "N"},
                         {"velocity", "m/s"},
                         {"static_friction", "1"},
                         {"kinetic_friction", "1"},
                         {"mean_friction", "1"},
                         {"moving_time", "s"},
                         {"distance", "m"},
                         {"drop_rate", "1/s"},
                         {"mean_drop", "N"},
                         {"largest_drop", "N"},
                         {"interval_variation", "1"},
                         {"time", "s"},
                         {"from", "N"},
                         {"to", "N"},
                         {"noise", "N"},
                         {"threshold", "1"}};
    return base::text_of(document);
}

using analysis::FrictionTrace;

namespace {

// an hour of four channels at 10 kHz
constexpr std::uint64_t most_samples = 150'000'000;

double to_four_digits(double value) {
    return std::round(value * 1e4) / 1e4;
}

}  // namespace

MeasuredFriction measured_friction(const FrictionTexts& texts, const std::function<void(const std::string&)>& note) {
    recordings::OpenOptions open;
    if (!texts.full_scale.empty()) open.full_scales = {recordings::parse_full_scale(texts.full_scale)};
    const std::unique_ptr<recordings::SignalFile> file = recordings::open_signal(texts.file, open);
    const signal::ChannelLayout layout = file->layout();
    const recordings::FrictionChannels places =
        recordings::friction_channels(layout, {texts.channel, texts.velocity_channel, texts.normal_channel});
    for (const std::string& each : file->facts().notes)
        note(each);
    const std::vector<signal::Signal> channels = signal::read_all(*file, most_samples);

    analysis::FrictionMeasurement measurement;
    measurement.rate = layout.rate;
    measurement.preload = base::parse_quantity(texts.preload, "N");
    measurement.force = channels[places.force].samples;
    if (places.velocity) measurement.velocity = channels[*places.velocity].samples;
    if (places.normal) measurement.normal_force = channels[*places.normal].samples;
    analysis::FrictionTraceOptions settings;
    settings.least_drop = texts.least_drop;
    settings.longest_drop = base::parse_quantity(texts.longest_drop, "s");
    FrictionTrace trace = analysis::friction_trace(measurement, settings);

    FrictionTest test;
    test.file = texts.file;
    test.channel = layout.channels[places.force].name;
    if (places.velocity) test.velocity_channel = layout.channels[*places.velocity].name;
    if (places.normal) test.normal_channel = layout.channels[*places.normal].name;
    test.rate = layout.rate;
    test.duration = signal::duration(channels[places.force]);
    test.preload = measurement.preload;
    test.velocity = !texts.velocity.empty() ? base::parse_quantity(texts.velocity, "m/s")
                    : places.velocity       ? recordings::usual_speed(channels[*places.velocity].samples)
                                            : std::numeric_limits<double>::quiet_NaN();
    test.condition = analysis::vda_condition(test.preload, test.velocity);
    for (const std::string& each : trace.notes)
        note(each);
    return {std::move(test), std::move(trace)};
}

namespace {

// what was measured is meant for all contacts, as it is for all of several joints
std::shared_ptr<const parameters::OwnStructure> without_own_friction(parameters::OwnStructure structure) {
    for (parameters::OwnContact& contact : structure.contacts) {
        contact.static_friction.reset();
        contact.kinetic_friction.reset();
    }
    return std::make_shared<const parameters::OwnStructure>(std::move(structure));
}

}  // namespace

std::string case_with_friction(parameters::Case c, const MeasuredFriction& measured) {
    const auto& [test, trace] = measured;
    const double mu_d = to_four_digits(trace.all.kinetic_friction.value);
    double mu_s = to_four_digits(trace.all.static_friction.value);
    if (!std::isfinite(mu_d)) base::refuse("the trace shows no kinetic coefficient", "nothing slides in it", "");
    std::string heading = fmt::format("friction coefficients measured: {}, preload {:g} N", test.file, test.preload);
    if (!std::isfinite(mu_s)) {
        mu_s = mu_d;
        heading += "\nno static coefficient was to be seen: it is set to the kinetic one";
    }
    if (mu_s < mu_d)
        base::refuse(fmt::format("the static coefficient, {:g}, comes out below the kinetic one, {:g}", mu_s, mu_d),
                     "the model needs it the other way round", "Is --preload right, and the sensor's zero?");
    if (c.own_structure) c.own_structure = without_own_friction(*c.own_structure);
    parameters::set_quantity(c, "contact.static_friction", mu_s);
    parameters::set_quantity(c, "contact.kinetic_friction", mu_d);
    return case_toml(c, {Comments::full, heading});
}

}  // namespace stridor::io
