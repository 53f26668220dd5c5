#include "stridor/explorer/served_world.hpp"

#include "stridor/io/case/toml_case.hpp"
#include "stridor/noise_library/library.hpp"

#include <system_error>

namespace stridor::explorer {

Preset preset_of(const io::TomlSource& source) {
    return preset_of(source, {});
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
