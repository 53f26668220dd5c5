#include "stridor/explorer/world.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/noise_library/library.hpp"
#include "stridor/parameters/case_key.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/temperature_table.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>

namespace stridor::explorer {

namespace {

Error not_at_hand(const std::string& what) {
    return {ErrorKind::input,
            {what + " not at hand", "the explorer opens no files on request",
             "Start it with the case: stridor explore CASE.toml."}};
}

}  // namespace

io::TomlSource source_of(const Preset& preset) {
    return {preset.toml, preset.file.empty() ? preset.name : preset.file, preset.overrides};
}

io::CaseReaders readers_of(const Preset& preset) {
    return {[&preset](const std::string& path) {
                if (!preset.samples_file.empty() && path == preset.samples_file) return preset.samples;
                throw not_at_hand("the samples of this drive are");
            },
            [&preset](const io::TomlDocument& document) {
                if (!preset.structure) throw not_at_hand("this structure is");
                return preset.structure->recipe ? io::read_enclosed_structure(document) : preset.structure;
            }};
}

std::vector<Preset> paper_presets() {
    std::vector<Preset> presets;
    for (std::size_t k = 0; k < parameters::paper_case_names.size(); ++k)
        presets.push_back({std::string(parameters::paper_case_names[k]),
                           io::case_toml(parameters::paper_case(static_cast<parameters::PaperCase>(k))), ""});
    return presets;
}

const Preset& preset_named(const World& world, std::string_view name) {
    const auto found = std::find_if(world.presets.begin(), world.presets.end(),
                                    [&](const Preset& preset) { return preset.name == name; });
    if (found != world.presets.end()) return *found;
    if (name == "file")
        throw Error(ErrorKind::input,
                    {"the case of this link is a file that is not here", "the link leans on the machine it came from",
                     "Ask for one made by Share, Copy link: that one holds the whole case."});
    throw Error(ErrorKind::input,
                {"there is no preset \"" + std::string(name) + "\"", "", "GET /api/start lists them."});
}

namespace {

// the page's own chart is over the friction, which cannot be set where it follows the temperature
io::AxisTexts axes_over_temperature(const parameters::Case& c) {
    const std::vector<double>& at = c.temperature.at;
    return {"contact.preload=1:80:64:linear",
            "temperature.value=" + base::shortest(at.front()) + ":" + base::shortest(at.back()) + ":64"};
}

// a range about a value, in equal ratios
std::string axis_about(const std::string& key, double value, int points) {
    constexpr double reach = 8.0;
    return key + "=" + base::shortest(value / reach) + ":" + base::shortest(value * reach) + ":" +
           std::to_string(points) + ":log";
}

// over the first two that the case has; where a cell costs more than one of the paper's the chart has fewer
io::AxisTexts axes_of_structure(const parameters::Case& c) {
    constexpr double wait = 40.0;  // [s] of one core, for a chart
    constexpr int fewest = 8, most = 24;
    const int points =
        static_cast<int>(std::clamp(std::sqrt(wait / structure_seconds(c)), double{fewest}, double{most}));
    std::vector<std::string> axes;
    if (parameters::belongs(c, "contact.preload") && c.contact.preload > 0.0)
        axes.push_back(axis_about("contact.preload", c.contact.preload, points));
    if (parameters::belongs(c, "contact.kinetic_friction") && c.contact.static_friction > 0.0)
        axes.push_back("contact.kinetic_friction=0:" + base::shortest(c.contact.static_friction) + ":" +
                       std::to_string(points));
    if (parameters::belongs(c, "drive.velocity"))
        axes.push_back(axis_about("drive.velocity", std::abs(c.drive.velocity), points));
    axes.push_back(axis_about("structure.stiffness_scale", c.structure_scales.stiffness, points));
    if (axes.size() < 2) axes.push_back("structure.damping_scale=0.1:10:" + std::to_string(points) + ":log");
    return {axes[0], axes[1]};
}

}  // namespace

double structure_seconds(const parameters::Case& c) {
    constexpr double step = 3.3e-8;  // [s] of one core for a row; a contact takes as much again
    const parameters::OwnStructure& own = *c.own_structure;
    const std::size_t rows = own.row.size();
    double highest = 0.0;  // [1/s^2] square of the angular frequency; Gershgorin's bound where the mass is diagonal
    for (std::size_t row = 0; row < rows; ++row) {
        double stiffness = 0.0;
        for (std::size_t column = 0; column < rows; ++column)
            stiffness += std::abs(own.stiffness[row * rows + column]);
        highest = std::max(highest, stiffness / own.mass[row * rows + row]);
    }
    const double steps = c.run.duration * std::sqrt(highest * c.structure_scales.stiffness);
    return steps * static_cast<double>(rows * (1 + own.contacts.size())) * step;
}

Preset preset_of(const io::TomlSource& source) {
    Preset preset{"file", source.text, source.name, source.overrides};
    const io::SamplesReader keep = [&](const std::string& path) {
        preset.samples_file = path;
        return preset.samples = recordings::read_sampled_file(path);
    };
    const io::TomlDocument document = io::parse_toml(source);
    // what is wrong is said here and not in the page
    const parameters::Case c = io::read_case(document, {keep, io::read_own_structure});
    preset.structure = c.own_structure;
    if (document.find("chart") != nullptr)
        preset.study = io::read_study(source);
    else if (parameters::temperature_column(c, "contact.kinetic_friction") != nullptr)
        preset.study = io::read_study(source, axes_over_temperature(c));
    else if (c.own_structure)
        preset.study = io::read_study(source, axes_of_structure(c));
    return preset;
}

World world_of(const std::filesystem::path& library) {
    World world;
    world.presets = paper_presets();
    world.library = library.empty() ? noise_library::default_library() : library;
    std::error_code ignored;
    if (!library.empty())
        static_cast<void>(noise_library::Library(world.library));  // likewise
    else if (!std::filesystem::exists(world.library, ignored))
        world.library.clear();
    return world;
}

}  // namespace stridor::explorer
