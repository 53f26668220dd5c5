#include "stridor/io/sound/named_sound.hpp"

#include "stridor/base/error.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/noise_library/library.hpp"
#include "stridor/sweep/cell_choice.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace stridor::io {

namespace {

using hearing::NamedSound;
using hearing::RecordedSound;
using hearing::SimulatedSound;

TomlSource warned_of(const std::string& path, const SoundLookup& lookup) {
    TomlSource source = load_toml(path);
    for (const base::Complaint& warning : case_warnings(parse_toml(source)))
        lookup.warn(warning);
    return source;
}

NamedSound sound_of_file(const std::string& name, const std::string& path, const recordings::OpenOptions& open,
                         const SoundLookup& lookup) {
    RecordedSound recorded{recordings::open_input(path), open, 0.0};
    const std::unique_ptr<recordings::SignalFile> file = recordings::open_signal(recorded.input, open);
    recorded.rate = file->layout().rate;
    for (const std::string& note : file->facts().notes)
        lookup.note(name + ": " + note);
    return {name, std::filesystem::path(path).filename().string(), "recording", std::move(recorded)};
}

NamedSound sound_of_entry(const std::string& text, const std::string& number, const SoundLookup& lookup) {
    std::int64_t id = 0;
    const auto end = number.data() + number.size();
    const auto parsed = std::from_chars(number.data(), end, id);
    if (parsed.ec != std::errc{} || parsed.ptr != end || id < 1)
        base::refuse("\"" + text + "\" names no entry", "an entry of the noise library has a number",
                     "For example library:3; `stridor library list` shows them.");
    noise_library::Library library = noise_library::open_library(lookup.library, noise_library::Access::read);
    const noise_library::Entry entry = library.get(std::span(&id, 1)).front();
    recordings::OpenOptions open;
    if (const std::optional<recordings::FullScale> full_scale = recordings::calibration_in(entry.calibration))
        open.full_scales = {*full_scale};
    NamedSound sound = sound_of_file(text, library.sound_file(entry).string(), open, lookup);
    sound.label = !entry.denomination.empty() ? entry.denomination : entry.file.empty() ? text : entry.file;
    if (!entry.system.empty()) sound.label = entry.system + ": " + sound.label;
    sound.origin = fmt::format("library entry {}", id);
    if (!entry.recorded.empty()) sound.origin += ", " + entry.recorded;
    return sound;
}

NamedSound sound_of_toml(const std::string& path, const SoundLookup& lookup) {
    const parameters::Case c = read_case(warned_of(path, lookup));
    const std::string stem = std::filesystem::path(path).stem().string();
    return {path, stem, "simulation", SimulatedSound{c}};
}

NamedSound sound_of_cell(const std::string& text, const std::string& path, const std::string& cell,
                         const SoundLookup& lookup) {
    const sweep::Study study = read_study(warned_of(path, lookup));
    const sweep::CellChoice choice = sweep::parse_cell(cell);
    const sweep::CellPlace place = sweep::nearest_cell(study, choice);
    SimulatedSound simulated{sweep::case_at(study, place)};
    if (choice.direction) simulated.stretches = hearing::heard_stretches(simulated.c, *choice.direction);
    if (choice.direction && simulated.stretches.empty())
        base::refuse("nothing of \"" + text + "\" can be heard", "the drive never moves that way in the window", "");
    return {text, sweep::cell_name(study, place), "simulation", std::move(simulated)};
}

recordings::OpenOptions with_channel(const std::string& text, const std::string& name) {
    if (name.empty())
        base::refuse("\"" + text + "\" names no channel", "it ends before its name", "For example rig.uff:channel=2.");
    recordings::OpenOptions open;
    open.channel_name = name;
    return open;
}

}  // namespace

NamedSound named_sound(const std::string& text, const SoundLookup& lookup) {
    constexpr std::string_view in_library = "library:";
    constexpr std::string_view of_channel = ":channel=";
    std::error_code ignored;
    const bool is_file = std::filesystem::exists(text, ignored);
    if (!is_file && text.starts_with(in_library)) return sound_of_entry(text, text.substr(in_library.size()), lookup);
    if (const std::size_t end = text.rfind(".toml:"); !is_file && end != std::string::npos)
        return sound_of_cell(text, text.substr(0, end + 5), text.substr(end + 6), lookup);
    if (text.ends_with(".toml")) return sound_of_toml(text, lookup);
    if (const std::size_t end = text.rfind(of_channel); !is_file && end != std::string::npos)
        return sound_of_file(text, text.substr(0, end), with_channel(text, text.substr(end + of_channel.size())),
                             lookup);
    return sound_of_file(text, text, {}, lookup);
}

NamedSound named_recording(const std::string& text, const SoundLookup& lookup) {
    if (text.ends_with(".toml") || text.find(".toml:") != std::string::npos)
        base::refuse("\"" + text + "\" is no recording", "it is a case or a chart",
                     "`stridor compare` lays simulations side by side; `stridor listen -o` makes a recording of one.");
    return named_sound(text, lookup);
}

}  // namespace stridor::io
