#include "stridor/io/simulation/json_friction.hpp"

#include "stridor/io/json_parts.hpp"

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

}  // namespace stridor::io
