#include "stridor/explorer/world.hpp"

#include "stridor/base/error.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <algorithm>

namespace stridor::explorer {

io::TomlSource source_of(const Preset& preset) {
    return {preset.toml, preset.file.empty() ? preset.name : preset.file, preset.overrides};
}

io::SamplesReader samples_of(const Preset& preset) {
    return [&preset](const std::string& path) {
        if (!preset.samples_file.empty() && path == preset.samples_file) return preset.samples;
        throw Error(ErrorKind::input,
                    {"the samples of this drive are not at hand", "the explorer opens no files on request",
                     "Start it with the case: stridor explore CASE.toml."});
    };
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

}  // namespace stridor::explorer
