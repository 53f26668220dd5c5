#include "stridor/explorer/world.hpp"

#include "stridor/base/error.hpp"
#include "stridor/integration/cost.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/sweep/ready_charts.hpp"

#include <algorithm>
#include <cmath>

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
    const auto kept = [](const auto& tables, const auto& path, const char* what) {
        const auto found = tables.find(path);
        if (found == tables.end()) throw not_at_hand(what);
        return found->second;
    };
    return {[&preset](const std::string& path) {
                if (!preset.samples_file.empty() && path == preset.samples_file) return preset.samples;
                throw not_at_hand("the samples of this drive are");
            },
            [&preset](const io::TomlDocument& document) {
                if (!preset.structure) throw not_at_hand("this structure is");
                return preset.structure->recipe ? io::read_enclosed_structure(document) : preset.structure;
            },
            [&preset, kept](const std::string& path) {
                return kept(preset.friction, path, "the rows of contact.friction_table are");
            },
            [&preset, kept](const std::string& path) {
                return kept(preset.force, path, "the rows of joint.axial_force are");
            },
            [&preset, kept](const std::string& path, const std::string& name) {
                return kept(preset.pairs, std::pair(path, name), "the rows of contact.pair are");
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

// a joint that does not stiffen takes milliseconds, whatever it is
bool takes_long(const parameters::Case& c) {
    return !parameters::has_plate(c) || !parameters::names_of_springs(c).empty();
}

// where a cell costs more than one of the paper's the chart has fewer
int chart_points(const parameters::Case& c) {
    constexpr double wait = 40.0;  // [s] of one core, for a chart
    constexpr double fewest = 8, of_structure = 24, of_joints = 64, of_several = 16;
    const double most = !parameters::has_plate(c)      ? of_structure
                        : parameters::has_one_joint(c) ? of_joints
                                                       : of_several;
    return static_cast<int>(takes_long(c) ? std::clamp(std::sqrt(wait / integration::cost(c).seconds), fewest, most)
                                          : most);
}

io::AxisTexts axes_around(const parameters::Case& c) {
    const auto [x, y] = sweep::usual_axes(c, chart_points(c));
    return {io::write_axis_text(x), io::write_axis_text(y)};
}

}  // namespace

Preset preset_of(const io::TomlSource& source, const io::CaseReaders& readers) {
    Preset preset{"file", source.text, source.name, source.overrides};
    const io::SamplesReader keep = [&](const std::string& path) {
        preset.samples_file = path;
        return preset.samples = readers.samples(path);
    };
    const io::TomlDocument document = io::parse_toml(source);
    // what is wrong is said here and not in the page
    const io::CaseReaders keeping{
        keep,
        [&](const io::TomlDocument& of) {
            if (!preset.structure) preset.structure = readers.structure(of);
            return preset.structure;
        },
        [&](const std::string& path) { return preset.friction[path] = readers.friction(path); },
        [&](const std::string& path) { return preset.force[path] = readers.force(path); },
        [&](const std::string& path, const std::string& name) {
            return preset.pairs[{path, name}] = readers.pair(path, name);
        }};
    const parameters::Case c = io::read_case(document, keeping);
    const io::AxisTexts axes = document.find("chart") != nullptr ? io::AxisTexts{} : axes_around(c);
    preset.study = io::read_study(document, axes, keeping);
    return preset;
}

}  // namespace stridor::explorer
