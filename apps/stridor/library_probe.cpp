#include "library.hpp"
#include "stridor/base/error.hpp"
#include "stridor/io/open_signal.hpp"

namespace stridor::app {

void probe_sound(const std::filesystem::path& file, noise_library::Entry& entry) {
    const std::unique_ptr<io::SignalFile> sound = io::open_signal(file.string());
    const signal::Layout& layout = sound->layout();
    entry.rate = layout.rate;
    entry.channels = static_cast<int>(layout.channels.size());
    if (layout.frames) entry.duration = static_cast<double>(*layout.frames) / layout.rate;
}

}  // namespace stridor::app
