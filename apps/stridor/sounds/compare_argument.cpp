#include "sounds/compare_argument.hpp"

#include "commands.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/sweep/cell_choice.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace stridor::app {

namespace {

// --- what an argument means

Asked asked_file(const std::string& name, const std::string& path, const recordings::OpenOptions& open) {
    Recorded recorded{recordings::open_input(path), open, 0.0};
    const std::unique_ptr<recordings::SignalFile> file = recordings::open_signal(recorded.input, open);
    recorded.rate = file->layout().rate;
    for (const std::string& note : file->facts().notes)
        console::say("stridor: note: " + name + ": " + note);
    return {name, std::filesystem::path(path).filename().string(), "recording", std::move(recorded)};
}

Asked asked_entry(const std::string& text, const std::string& number, const LibraryOption& option) {
    std::int64_t id = 0;
    const auto end = number.data() + number.size();
    const auto parsed = std::from_chars(number.data(), end, id);
    if (parsed.ec != std::errc{} || parsed.ptr != end || id < 1)
        base::refuse("\"" + text + "\" names no entry", "an entry of the noise library has a number",
                     "For example library:3; `stridor library list` shows them.");
    noise_library::Library library = open_library(option, noise_library::Access::read);
    const noise_library::Entry entry = library.get(std::span(&id, 1)).front();
    recordings::OpenOptions open;
    if (const std::optional<recordings::FullScale> full_scale = recordings::calibration_in(entry.calibration))
        open.full_scales = {*full_scale};
    Asked asked = asked_file(text, library.sound_file(entry).string(), open);
    asked.label = !entry.denomination.empty() ? entry.denomination : entry.file.empty() ? text : entry.file;
    if (!entry.system.empty()) asked.label = entry.system + ": " + asked.label;
    asked.origin = fmt::format("library entry {}", id);
    if (!entry.recorded.empty()) asked.origin += ", " + entry.recorded;
    return asked;
}

Asked asked_case(const std::string& path) {
    const parameters::Case c = io::read_case(load_source(path));
    const std::string stem = std::filesystem::path(path).stem().string();
    return {path, stem, "simulation", SimulatedSound{path, c, {}}};
}

Asked asked_cell(const std::string& text, const std::string& path, const std::string& cell) {
    const sweep::Study study = io::read_study(load_source(path));
    const sweep::CellChoice choice = sweep::parse_cell(cell);
    const sweep::CellPlace place = sweep::nearest_cell(study, choice);
    SimulatedSound simulated{text, sweep::case_at(study, place), {}};
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

Asked asked_sound(const std::string& text, const LibraryOption& library) {
    constexpr std::string_view in_library = "library:";
    constexpr std::string_view of_channel = ":channel=";
    std::error_code ignored;
    const bool is_file = std::filesystem::exists(text, ignored);
    if (!is_file && text.starts_with(in_library)) return asked_entry(text, text.substr(in_library.size()), library);
    if (const std::size_t end = text.rfind(".toml:"); !is_file && end != std::string::npos)
        return asked_cell(text, text.substr(0, end + 5), text.substr(end + 6));
    if (text.ends_with(".toml")) return asked_case(text);
    if (const std::size_t end = text.rfind(of_channel); !is_file && end != std::string::npos)
        return asked_file(text, text.substr(0, end), with_channel(text, text.substr(end + of_channel.size())));
    return asked_file(text, text, {});
}

}  // namespace stridor::app
