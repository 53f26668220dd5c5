#pragma once

#include "stridor/hearing/live_ear.hpp"
#include "stridor/io/sound/live_events.hpp"
#include "stridor/noise_library/entry.hpp"
#include "stridor/noise_library/library.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/recordings/calibration.hpp"
#include "stridor/storage/new_file.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace stridor::app {

/// Where the clips of noises are kept.
struct KeepOptions {
    std::string folder;              // empty: in none
    std::string library;             // empty: in none
    std::vector<std::string> about;  // "system=door hinge", of each entry
};

void add_keep_options(CLI::App& command, KeepOptions& options);

/// Returns an entry with the facts that were asked for. Throws `Error` (input) for a fact that no entry has.
noise_library::Entry entry_of(const KeepOptions& options);

/// Keeps a clip of each noise: in a folder, in a noise library, in both or not at all.
class ClipKeeper {
public:
    /// Makes the folder and opens the library; `about` is what each entry begins with. Throws `Error` (io) if that
    /// fails.
    ClipKeeper(const KeepOptions& options, noise_library::Entry about, const io::LiveInput& input,
               recordings::WavSamples samples, std::vector<recordings::FullScale> full_scales);

    /// Keeps a clip; `time` [s since 1970] is when its noise began. A failure is told in the answer: the next clip may
    /// find room again.
    io::KeptClip keep(const hearing::LiveNoise& noise, signal::Source& clip, double time);

    /// Throws `Error` (io) if any clip could not be kept.
    void expect_no_failure() const;

private:
    void write(const std::filesystem::path& file, signal::Source& clip) const;
    noise_library::Entry entry_of(const hearing::LiveNoise& noise, double time) const;

    std::string source_;
    recordings::WavSamples samples_;
    std::vector<recordings::FullScale> full_scales_;
    std::filesystem::path folder_;
    noise_library::Entry about_;
    std::optional<storage::PrivateFolder> own_folder_{};  // where no other is named
    std::optional<noise_library::Library> library_{};
    std::size_t failures_ = 0;
    std::string first_failure_{};
};

}  // namespace stridor::app
