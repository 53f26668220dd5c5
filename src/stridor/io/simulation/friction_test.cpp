#include "stridor/io/simulation/friction_test.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/json_members.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/io/simulation/friction_test_json.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "stridor/recordings/rig_channels.hpp"

#include <fmt/format.h>

#include <array>
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

using analysis::ForceDrop;
using analysis::FrictionFigures;

constexpr auto test_members = std::to_array<Member<FrictionTest>>({
    {{"file"}, [](const FrictionTest& test) -> Json { return test.file; }},
    {{"channel"}, [](const FrictionTest& test) { return base::text_or_null(test.channel); }},
    {{"velocity_channel"}, [](const FrictionTest& test) { return base::text_or_null(test.velocity_channel); }},
    {{"normal_channel"}, [](const FrictionTest& test) { return base::text_or_null(test.normal_channel); }},
    {{"rate", "Hz"}, &FrictionTest::rate},
    {{"duration", "s"}, &FrictionTest::duration},
    {{"preload", "N"}, &FrictionTest::preload},
    {{"velocity", "m/s"}, &FrictionTest::velocity},
    {{"condition"}, [](const FrictionTest& test) { return base::text_or_null(test.condition); }},
});

constexpr auto figure_members = std::to_array<Member<FrictionFigures>>({
    {{"direction"},
     [](const FrictionFigures& figures) -> Json {
         return figures.direction == 0 ? "all" : figures.direction > 0 ? "going" : "coming";
     }},
    {{"static_friction", "1"}, [](const FrictionFigures& figures) { return coefficient(figures.static_friction); }},
    {{"kinetic_friction", "1"}, [](const FrictionFigures& figures) { return coefficient(figures.kinetic_friction); }},
    {{"kinetic_source"},
     [](const FrictionFigures& figures) -> Json {
         return json_parts::name_of<analysis::KineticSource>(analysis::kinetic_source_names, figures.source);
     }},
    {{"mean_friction", "1"}, &FrictionFigures::mean_friction},
    {{"moving_time", "s"}, &FrictionFigures::moving_time},
    {{"distance", "m"}, &FrictionFigures::distance},
    {{"drops"}, [](const FrictionFigures& figures) -> Json { return figures.drops; }},
    {{"drop_rate", "1/s"}, &FrictionFigures::drop_rate},
    {{"mean_drop", "N"}, &FrictionFigures::mean_drop},
    {{"largest_drop", "N"}, &FrictionFigures::largest_drop},
    {{"interval_variation", "1"}, &FrictionFigures::variation},
});

constexpr auto drop_members = std::to_array<Member<ForceDrop>>({
    {{"time", "s"}, &ForceDrop::time},
    {{"duration", "s"}, &ForceDrop::duration},
    {{"from", "N"}, &ForceDrop::from},
    {{"to", "N"}, &ForceDrop::to},
    {{"direction"}, [](const ForceDrop& drop) -> Json { return drop.direction > 0 ? "going" : "coming"; }},
});

}  // namespace

std::string friction_json(const FrictionTest& test, const analysis::FrictionTrace& trace) {
    Json document = json_parts::opening("friction");
    document["test"] = object_of(test_members, test);
    document["all"] = object_of(figure_members, trace.all);
    document["directions"] = objects_of(figure_members, trace.directions);
    document["drops"] = objects_of(drop_members, trace.drops);
    document["noise"] = trace.noise;
    document["threshold"] = trace.threshold;
    document["notes"] = trace.notes;
    Json& units = document["units"] = Json::object();
    put_units(units, "", test_members);
    put_units(units, "", figure_members);
    put_units(units, "", drop_members);
    units["noise"] = "N";
    units["threshold"] = "1";
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

RecordedFriction recorded_friction(const FrictionTexts& texts, const std::function<void(const std::string&)>& note) {
    recordings::OpenOptions open;
    if (!texts.full_scale.empty()) open.full_scales = {recordings::parse_full_scale(texts.full_scale)};
    const std::unique_ptr<recordings::SignalFile> file = recordings::open_signal(texts.file, open);
    const signal::ChannelLayout layout = file->layout();
    const recordings::FrictionChannels places =
        recordings::friction_channels(layout, {texts.channel, texts.velocity_channel, texts.normal_channel});
    for (const std::string& each : file->facts().notes)
        note(each);
    RecordedFriction recorded;
    recorded.channels = signal::read_all(*file, most_samples);
    const std::vector<signal::Signal>& channels = recorded.channels;
    analysis::FrictionMeasurement& measurement = recorded.measurement;
    measurement.rate = layout.rate;
    measurement.preload = base::parse_quantity(texts.preload, "N");
    measurement.force = channels[places.force].samples;
    if (places.velocity) measurement.velocity = channels[*places.velocity].samples;
    if (places.normal) measurement.normal_force = channels[*places.normal].samples;

    FrictionTest& test = recorded.test;
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
    return recorded;
}

analysis::FrictionTraceOptions trace_options(const FrictionTexts& texts) {
    analysis::FrictionTraceOptions settings;
    settings.least_drop = texts.least_drop;
    settings.longest_drop = base::parse_quantity(texts.longest_drop, "s");
    return settings;
}

base::Json test_object(const FrictionTest& test, base::Json& units) {
    put_units(units, "", test_members);
    return object_of(test_members, test);
}

MeasuredFriction measured_friction(const FrictionTexts& texts, const std::function<void(const std::string&)>& note) {
    RecordedFriction recorded = recorded_friction(texts, note);
    FrictionTrace trace = analysis::friction_trace(recorded.measurement, trace_options(texts));
    for (const std::string& each : trace.notes)
        note(each);
    return {std::move(recorded.test), std::move(trace)};
}

namespace {

// to four digits, as a model takes them
struct ModelCoefficients {
    double mu_s = 0.0;  // [1]
    double mu_d = 0.0;  // [1]
    bool has_static = true;
};

ModelCoefficients model_coefficients(const FrictionTrace& trace) {
    const double mu_d = to_four_digits(trace.all.kinetic_friction.value);
    double mu_s = to_four_digits(trace.all.static_friction.value);
    if (!std::isfinite(mu_d)) base::refuse("the trace shows no kinetic coefficient", "nothing slides in it", "");
    const bool has_static = std::isfinite(mu_s);
    if (!has_static) mu_s = mu_d;
    if (mu_s < mu_d)
        base::refuse(fmt::format("the static coefficient, {:g}, comes out below the kinetic one, {:g}", mu_s, mu_d),
                     "the model needs it the other way round", "Is --preload right, and the sensor's zero?");
    return {mu_s, mu_d, has_static};
}

std::string toml_string(const std::string& text) {
    return base::text_of(Json(text));
}

}  // namespace

std::string pair_row_opening(const PairConditions& conditions, const std::string& source, double preload) {
    std::string row = "[[pair]]\nname = " + toml_string(conditions.name) + "\nsource = " + toml_string(source) + "\n";
    if (!conditions.temperature.empty()) {
        base::parse_quantity(conditions.temperature, "degC");
        row += "temperature = " + toml_string(conditions.temperature) + "\n";
    }
    if (!conditions.humidity.empty()) {
        base::parse_quantity(conditions.humidity, "%");
        row += "humidity = " + toml_string(conditions.humidity) + "\n";
    }
    return row + fmt::format("load = \"{:g} N\"\n", preload);
}

std::string pair_row(const MeasuredFriction& measured, const PairConditions& conditions) {
    const auto [mu_s, mu_d, has_static] = model_coefficients(measured.trace);
    std::string row = pair_row_opening(conditions, measured.test.file, measured.test.preload);
    row += fmt::format("static_friction = {:g}\nkinetic_friction = {:g}\n", mu_s, mu_d);
    if (!has_static) row += "# no static coefficient was to be seen: it is set to the kinetic one\n";
    return row;
}

std::string case_with_friction(parameters::Case c, const MeasuredFriction& measured) {
    const auto [mu_s, mu_d, has_static] = model_coefficients(measured.trace);
    std::string heading =
        fmt::format("friction coefficients measured: {}, preload {:g} N", measured.test.file, measured.test.preload);
    if (!has_static) heading += "\nno static coefficient was to be seen: it is set to the kinetic one";
    parameters::share_friction(c);
    parameters::set_quantity(c, "contact.static_friction", mu_s);
    parameters::set_quantity(c, "contact.kinetic_friction", mu_d);
    return case_toml(c, {Comments::full, heading});
}

}  // namespace stridor::io
