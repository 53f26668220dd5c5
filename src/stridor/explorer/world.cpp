#include "stridor/explorer/world.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/noise_library/library.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/temperature_table.hpp"

#include <algorithm>
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
            [&preset](const io::TomlDocument&) {
                if (preset.structure) return preset.structure;
                throw not_at_hand("this structure is");
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

}  // namespace

Preset preset_of(const io::TomlSource& source) {
    Preset preset{"file", source.text, source.name, source.overrides};
    const io::SamplesReader keep = [&](const std::string& path) {
        preset.samples_file = path;
        return preset.samples = recordings::read_sampled_file(path);
    };
    const io::TomlDocument document = io::parse_toml(source);
    // what is wrong is said here and not in the page
    const parameters::Case c = io::read_case(document, {keep, io::read_own_structure});
    if (c.own_structure)
        throw Error(ErrorKind::input,
                    {"the page shows joints on a plate", "the file has a structure of its own, as [structure]",
                     "Look at it with `stridor simulate --figure`, `stridor chart` and `stridor report`."},
                    document.find("structure")->key_place);
    if (document.find("chart") != nullptr)
        preset.study = io::read_study(source);
    else if (parameters::temperature_column(c, "contact.kinetic_friction") != nullptr)
        preset.study = io::read_study(source, axes_over_temperature(c));
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
