// What a simulated second costs against the number of contacts and of modes, by events and by steps, and what ready
// cases cost beside what `stridor check` tells. Prints tables, and draws the first two where a file is named:
// `build-bench/benchmarks/cost_benchmark cost.png`.

#include "stridor/drawing/palette.hpp"
#include "stridor/drawing/picture.hpp"
#include "stridor/integration/cost.hpp"
#include "stridor/integration/series/taylor.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/integration/steps/moreau.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/model/built/bowed_string.hpp"
#include "stridor/record/schedule.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "support/structures/meshed_strip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

namespace stridor {
namespace {

constexpr double step = 1e-6;  // [s] of time stepping

// a simulated second of one structure
struct Cost {
    std::size_t contacts = 0, modes = 0;
    double events = 0.0;  // [s] of processor time
    double steps = 0.0;   // [s] likewise
};

double processor_time() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

enum class Way { events, steps };

// the least of three
double cost_of(const support::RubberStrip& given, double duration, Way way) {
    parameters::Case c;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = given.velocity;
    c.run.duration = c.run.window = duration;
    double least = 0.0;
    for (int run = 0; run < 3; ++run) {
        const double begin = processor_time();
        record::Recorder recorder(record::schedule(c), {}, model::dofs_of(given.structure),
                                  static_cast<int>(given.structure.contacts.size()));
        const integration::Motion motion =
            way == Way::steps
                ? integration::integrate_moreau(given.structure, c.drive, given.start, {step}, std::move(recorder))
                : integration::integrate_taylor(given.structure, c.drive, given.start, {parameters::EarlyEnding::never},
                                                std::move(recorder));
        if (motion.outcome.reason != integration::Reason::completed) throw std::runtime_error("a run did not complete");
        const double cost = (processor_time() - begin) / duration;
        least = run == 0 ? cost : std::min(least, cost);
    }
    return least;
}

Cost cost_of(const support::RubberStrip& given, double duration) {
    return {given.structure.contacts.size(), static_cast<std::size_t>(model::dofs_of(given.structure)),
            cost_of(given, duration, Way::events), cost_of(given, duration, Way::steps)};
}

std::vector<Cost> costs_of_strips() {
    std::vector<Cost> costs;
    for (const int columns : {1, 2, 4, 9, 14, 19})
        costs.push_back(cost_of(support::meshed_strip(columns, support::MeshMass::lumped), 0.4 / columns));
    return costs;
}

std::vector<Cost> costs_of_strings() {
    std::vector<Cost> costs;
    const model::BowedString string;
    for (const int modes : {7, 15, 31, 63, 127, 255}) {
        support::RubberStrip given{model::bowed_string(string, modes), {Eigen::VectorXd::Zero(modes + 1), {}}, 0.1};
        given.start.velocity = model::helmholtz_motion(string, modes, given.velocity);
        costs.push_back(cost_of(given, 4.0 / modes));
    }
    return costs;
}

void print(const char* what, const std::vector<Cost>& costs) {
    fmt::print("| {}: modes | contacts | events [s] | steps of 1 us [s] |\n| --- | --- | --- | --- |\n", what);
    for (const Cost& cost : costs)
        fmt::print("| {} | {} | {:.2g} | {:.2g} |\n", cost.modes, cost.contacts, cost.events, cost.steps);
}

// runs without early endings, long enough to be timed
void print_told(const std::vector<std::string>& ready_cases) {
    fmt::print("| ready case | told [s] | took [s] |\n| --- | --- | --- |\n");
    for (const std::string& name : ready_cases) {
        parameters::Case c = io::read_case({io::ready_file(name), name, {}});
        c.run.early_ending = parameters::EarlyEnding::never;
        c.run.duration *= std::max(1.0, 0.2 / integration::cost(c).seconds);
        const double begin = processor_time();
        integration::simulate(c);
        fmt::print("| {} | {:.2g} | {:.2g} |\n", name, integration::cost(c).seconds, processor_time() - begin);
    }
}

constexpr drawing::Colour colour_of_steps{0xB0, 0x5A, 0x00};

drawing::Panel panel_of(const std::vector<Cost>& costs, std::size_t Cost::*along) {
    drawing::Panel panel;
    panel.grid = drawing::Grid::both;
    panel.x.scale = panel.y.scale = drawing::AxisScale::logarithmic;
    panel.x.unit = "1";
    panel.y.label = "time per simulated second";
    panel.y.unit = "s/s";
    panel.y.range = {0.005, 100.0};
    for (const Way way : {Way::events, Way::steps}) {
        const drawing::Colour colour = way == Way::events ? drawing::accent : colour_of_steps;
        drawing::Line line{{}, {}, {colour, 1.0, drawing::Dash::solid}};
        for (const Cost& cost : costs) {
            line.x.push_back(static_cast<double>(cost.*along));
            line.y.push_back(way == Way::events ? cost.events : cost.steps);
        }
        const drawing::Mark mark = way == Way::events ? drawing::Mark::disc : drawing::Mark::square;
        panel.layers.emplace_back(line);
        panel.layers.emplace_back(drawing::Points{line.x, line.y, colour, 4.0, {}, mark});
    }
    return panel;
}

void draw(const std::filesystem::path& file, const std::vector<Cost>& strips, const std::vector<Cost>& strings) {
    drawing::Scene scene;
    scene.title = "Cost against contacts and modes";
    scene.caption = {
        "One processor; Taylor engine without early endings, Moreau's steps of 1 us without a second run."};
    scene.height = 85.0;
    scene.column_widths = {1.0, 1.0};
    scene.panels = {panel_of(strips, &Cost::contacts), panel_of(strings, &Cost::modes)};
    scene.panels[0].title = "a) strip of rubber, 8 modes a contact";
    scene.panels[0].x.label = "contacts";
    scene.panels[0].x.range = {1.5, 30.0};
    scene.panels[1].title = "b) bowed string, one contact";
    scene.panels[1].column = 1;
    scene.panels[1].x.label = "modes";
    scene.panels[1].x.range = {6.0, 400.0};
    scene.panels[1].y.label = {};
    scene.legend = {{"by events", drawing::Points{{}, {}, drawing::accent, 4.0, {}}},
                    {"by steps of 1 us", drawing::Points{{}, {}, colour_of_steps, 4.0, {}, drawing::Mark::square}}};
    storage::write_file(file.string(), drawing::render(scene, drawing::format_of(file)));
}

}  // namespace
}  // namespace stridor

// `./dev bench --benchmark_filter=REGEX` is meant for Google Benchmark; what it leaves out is left out here
int main(int count, char** arguments) {
    using namespace stridor;
    const std::string argument = count > 1 ? arguments[1] : "";
    const std::string filter = "--benchmark_filter=";
    if (argument.starts_with(filter) && !std::regex_search("cost", std::regex(argument.substr(filter.size()))))
        return 0;
    const std::vector<Cost> strips = costs_of_strips(), strings = costs_of_strings();
    print("strip of rubber", strips);
    print("bowed string", strings);
    print_told({"squeal", "weatherstrip", "wiper", "wiper-wet", "seal-lip", "two-lips", "chain", "string"});
    if (!argument.empty() && !argument.starts_with("--")) draw(argument, strips, strings);
    return 0;
}
