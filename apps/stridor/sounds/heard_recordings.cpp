#include "sounds/heard_recordings.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/classification/sound_rules.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "stridor/recordings/sidecar.hpp"
#include "stridor/storage/command_cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <system_error>
#include <utility>

namespace stridor::app {

namespace {

namespace fs = std::filesystem;
using classification::category_names;

// 0 for what is not there
std::uintmax_t size_of(const std::string& file) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    return error ? 0 : size;
}

// in which state a file is: two that agree in this are taken for the same, their bytes are not read
std::string state_of(const std::string& file) {
    std::error_code error;
    const fs::file_time_type written = fs::last_write_time(file, error);
    if (error) return "none";
    return fmt::format("{} bytes, {}", size_of(file), written.time_since_epoch().count());
}

// all that decides what is heard
std::string heard_text(std::span<const io::Expectation> expectations, const parameters::SoundThresholds& thresholds) {
    std::string text = "recordings\n";
    for (const parameters::SoundThreshold& threshold : parameters::sound_thresholds())
        text += fmt::format("{} = {}\n", threshold.name, base::shortest(thresholds.*threshold.member));
    for (const io::Expectation& each : expectations) {
        std::error_code error;
        text += fmt::format("{}: {}; sidecar: {}\n", fs::absolute(each.file, error).string(), state_of(each.file),
                            state_of(recordings::sidecar_path(each.file)));
    }
    return text;
}

// "creak 68.7 % of the energy is creak"
std::string packed(const io::HeardRecording& heard) {
    return std::string(classification::name(heard.heard)) + " " + heard.reason;
}

std::optional<io::HeardRecording> unpacked(const io::Expectation& expectation, const std::string& text) {
    const std::size_t blank = text.find(' ');
    const auto category = std::find(category_names.begin(), category_names.end(), text.substr(0, blank));
    if (blank == std::string::npos || category == category_names.end()) return std::nullopt;
    return io::HeardRecording{expectation, static_cast<classification::Category>(category - category_names.begin()),
                              text.substr(blank + 1)};
}

// How far a row of recordings is by their bytes; few and short ones go without.
class HearingDisplay {
public:
    explicit HearingDisplay(std::span<const io::Expectation> expectations) : count_(expectations.size()) {
        for (const io::Expectation& each : expectations)
            total_ += size_of(each.file);
    }
    void begin(const std::string& file) {
        file_ = fs::path(file).filename().string();
        size_ = size_of(file);
        ++number_;
    }
    void show(double share) {
        if (total_ == 0 || !console::takes_long(count_, total_)) return;
        const double done = static_cast<double>(done_) + share * static_cast<double>(size_);
        display_.show(done / static_cast<double>(total_), fmt::format("{} of {}: {}", number_, count_, file_));
    }
    void end() { done_ += size_; }

private:
    console::ShareDisplay display_{"listened to", console::TimeLeft::shown};
    std::size_t count_;
    std::size_t number_ = 0;
    std::string file_;
    std::uintmax_t total_ = 0;  // [bytes]
    std::uintmax_t done_ = 0;   // [bytes]
    std::uintmax_t size_ = 0;   // [bytes] of the one that is heard
};

io::HeardRecording hear_recording(const io::Expectation& expectation, const parameters::SoundThresholds& thresholds,
                                  const std::stop_token& stop, HearingDisplay& display) {
    const std::unique_ptr<recordings::SignalFile> file = recordings::open_signal(expectation.file);
    const double frames = static_cast<double>(file->layout().frames.value_or(0));
    const classification::RecordingVerdict verdict = verdict_on(*file, thresholds, [&](std::uint64_t done) {
        if (stop.stop_requested())
            throw Error(ErrorKind::interrupted,
                        {"stopped in " + expectation.file, "the recordings heard so far are kept",
                         "Run the same command again to go on."});
        if (frames > 0.0) display.show(std::min(1.0, static_cast<double>(done) / frames));
    });
    return {expectation, verdict.category, verdict.reasons.front()};
}

}  // namespace

classification::RecordingVerdict verdict_on(signal::Source& source, const parameters::SoundThresholds& thresholds,
                                            const sound::AnalysisProgress& progress) {
    const std::vector<sound::SoundAnalysis> channels = sound::analyse(source, progress);
    return classification::classify_recording(channels[sound::loudest(channels)].stretches, thresholds);
}

std::vector<io::HeardRecording> heard_recordings(std::span<const io::Expectation> expectations,
                                                 const parameters::SoundThresholds& thresholds,
                                                 const std::stop_token& stop) {
    storage::CommandCache kept("evaluate", heard_text(expectations, thresholds), console::say);
    HearingDisplay display(expectations);
    std::vector<io::HeardRecording> heard;
    for (std::size_t k = 0; k < expectations.size(); ++k) {
        const io::Expectation& expectation = expectations[k];
        display.begin(expectation.file);
        std::optional<io::HeardRecording> known;
        if (storage::KeptResults* results = kept.results())
            if (const std::optional<std::string> text = results->find(k)) known = unpacked(expectation, *text);
        if (!known) {
            known = hear_recording(expectation, thresholds, stop, display);
            if (storage::KeptResults* results = kept.results()) results->keep(k, packed(*known));
            display.show(1.0);
        }
        heard.push_back(std::move(*known));
        display.end();
    }
    kept.finish();
    return heard;
}

}  // namespace stridor::app
