#include "sounds/clip_keeper.hpp"

#include "arguments.hpp"
#include "interrupt.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/library/recording_probe.hpp"
#include "stridor/noise_library/add_recordings.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace stridor::app {

namespace {

// "noise-20261127T154225.123Z-creak-channel-2.wav"
std::string clip_name(const hearing::LiveNoise& noise, double time) {
    std::string stamp = io::stamp_text(time);
    std::erase_if(stamp, [](char c) { return c == '-' || c == ':'; });
    return fmt::format("noise-{}-{}-channel-{}.wav", stamp, classification::name(noise.strongest.category()),
                       noise.strongest.channel + 1);
}

void set_fact(noise_library::Entry& entry, const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string name(base::trimmed(text.substr(0, std::min(equals, text.size()))));
    const noise_library::EntryField* field = noise_library::find_field(name);
    if (equals == std::string::npos)
        throw Error(ErrorKind::input, {"\"" + text + "\" says nothing of an entry", "FIELD=VALUE is needed",
                                       "`stridor library add --help` lists the fields."});
    if (field == nullptr)
        throw Error(ErrorKind::input,
                    {"an entry has no field \"" + name + "\"", "a noise library does not know it",
                     base::did_you_mean(name, noise_library::field_names([](const noise_library::EntryField& each) {
                                            return each.writer == noise_library::Writer::user;
                                        }),
                                        "`stridor library add --help` lists the fields.")});
    noise_library::set_from_text(entry, *field, base::trimmed(text.substr(equals + 1)));
}

}  // namespace

void add_keep_options(CLI::App& command, KeepOptions& options) {
    command.add_option("--keep", options.folder, "write a WAV file of each noise into this folder")->type_name("DIR");
    command.add_option("--library", options.library, "add each noise to this noise library")->type_name("FILE");
    command
        .add_option("--about", options.about,
                    "what the library shall say of each noise: --about \"system=door hinge\" (repeatable)")
        ->type_name("FIELD=VALUE")
        ->allow_extra_args(false);
}

noise_library::Entry entry_of(const KeepOptions& options) {
    noise_library::Entry entry;
    for (const std::string& text : options.about)
        at_option("--about", text, [&] { set_fact(entry, text); });
    return entry;
}

ClipKeeper::ClipKeeper(const KeepOptions& options, noise_library::Entry about, const io::LiveInput& input,
                       recordings::WavSamples samples, std::vector<recordings::FullScale> full_scales)
    : source_(input.name),
      samples_(samples),
      full_scales_(std::move(full_scales)),
      folder_(options.folder),
      about_(std::move(about)) {
    if (!options.folder.empty()) storage::make_folder(folder_, "Name another --keep.");
    if (options.library.empty()) return;
    library_.emplace(noise_library::open_library(options.library, noise_library::Access::fill, waiting()));
    if (options.folder.empty()) folder_ = own_folder_.emplace().path();
}

void ClipKeeper::write(const std::filesystem::path& file, signal::Source& clip) const {
    recordings::WavOptions options;
    options.samples = samples_;
    options.full_scales = full_scales_;
    options.description = "stridor listen-in, " + source_;
    recordings::write_wav(file.string(), clip, options);
}

noise_library::Entry ClipKeeper::entry_of(const hearing::LiveNoise& noise, double time) const {
    constexpr std::size_t date = 10;  // bytes of YYYY-MM-DD
    noise_library::Entry entry = about_;
    const std::string stamp = io::stamp_text(time);
    if (entry.date.empty()) entry.date = stamp.substr(0, date);
    const std::string heard =
        fmt::format("heard by stridor listen-in from {} at {}: {} in channel {}, {:.3f} to {:.3f} s of this clip",
                    source_, stamp, classification::name(noise.strongest.category()), noise.strongest.channel + 1,
                    noise.from - noise.clip_from, noise.to - noise.clip_from);
    entry.notes += (entry.notes.empty() ? "" : "\n") + heard;
    return entry;
}

io::KeptClip ClipKeeper::keep(const hearing::LiveNoise& noise, signal::Source& clip, double time) {
    io::KeptClip kept;
    if (folder_.empty()) return kept;
    const std::filesystem::path file = folder_ / clip_name(noise, time);
    try {
        write(file, clip);
        if (!own_folder_) kept.file = file.string();
        if (!library_) return kept;
        const io::JudgingOptions judging{io::Judging::by_ear, std::to_string(noise.strongest.channel + 1), {}};
        kept.entry =
            noise_library::add_recording(*library_, {file, entry_of(noise, time), noise_library::Twins::accept},
                                         io::probe_of(judging, {}))
                .id;
    } catch (const Error& error) {
        kept.failure = error.what();
        if (++failures_ == 1) first_failure_ = error.what();
    }
    if (own_folder_) {
        std::error_code ignored;
        std::filesystem::remove(file, ignored);
    }
    return kept;
}

void ClipKeeper::expect_no_failure() const {
    if (failures_ == 0) return;
    throw Error(ErrorKind::io, {fmt::format("{} of the clips could not be kept", failures_), first_failure_, ""});
}

}  // namespace stridor::app
