#include "stridor/hearing/heard_recordings.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/classification/recording_verdict.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "stridor/recordings/sidecar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

namespace stridor::hearing {

namespace {

namespace fs = std::filesystem;
using classification::Category;
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

// "creak 0.87 42 % of the energy"
std::string packed(const HeardRecording& heard) {
    return fmt::format("{} {} {}", classification::name(heard.heard), base::shortest(heard.probability), heard.reason);
}

std::optional<HeardRecording> unpacked(const Expectation& expectation, const std::string& text) {
    const std::size_t first = text.find(' ');
    const std::size_t second = first == std::string::npos ? first : text.find(' ', first + 1);
    if (second == std::string::npos) return std::nullopt;
    const auto category = std::find(category_names.begin(), category_names.end(), text.substr(0, first));
    double probability = 0.0;
    const auto read = std::from_chars(text.data() + first + 1, text.data() + second, probability);
    if (category == category_names.end() || read.ec != std::errc{}) return std::nullopt;
    return HeardRecording{expectation, static_cast<classification::Category>(category - category_names.begin()),
                          text.substr(second + 1), probability};
}

HeardRecording hear_recording(const Expectation& expectation, const RecordingHearing& hearing) {
    const std::unique_ptr<recordings::SignalFile> file = recordings::open_signal(expectation.file);
    const double frames = static_cast<double>(file->layout().frames.value_or(0));
    const classification::RecordingVerdict verdict = verdict_on(*file, hearing.thresholds, [&](std::uint64_t done) {
        if (hearing.stop.stop_requested())
            throw Error(ErrorKind::interrupted,
                        {"stopped in " + expectation.file, "the recordings heard so far are kept",
                         "Run the same command again to go on."});
        if (frames > 0.0) hearing.progress(std::min(1.0, static_cast<double>(done) / frames));
    });
    return {expectation, verdict.category, verdict.reasons.front(), verdict.probability};
}

}  // namespace

bool is_right(const HeardRecording& recording) {
    const std::vector<Category>& accepted = recording.expectation.categories;
    return std::find(accepted.begin(), accepted.end(), recording.heard) != accepted.end();
}

classification::RecordingVerdict verdict_on(signal::Source& source, const parameters::SoundThresholds& thresholds,
                                            const sound::AnalysisProgress& progress) {
    const std::vector<sound::SoundAnalysis> channels = sound::analyse(source, progress);
    return classification::verdict_on(channels[sound::loudest(channels)], thresholds);
}

std::string heard_text(std::span<const Expectation> expectations, const parameters::SoundThresholds& thresholds) {
    std::string text = "recordings\n";
    for (const parameters::SoundThreshold& threshold : parameters::sound_thresholds())
        text += fmt::format("{} = {}\n", threshold.name, base::shortest(thresholds.*threshold.member));
    for (const Expectation& each : expectations) {
        std::error_code error;
        text += fmt::format("{}: {}; sidecar: {}\n", fs::absolute(each.file, error).string(), state_of(each.file),
                            state_of(recordings::sidecar_path(each.file)));
    }
    return text;
}

std::vector<HeardRecording> hear(std::span<const Expectation> expectations, const RecordingHearing& hearing) {
    std::vector<HeardRecording> heard;
    for (std::size_t k = 0; k < expectations.size(); ++k) {
        const Expectation& expectation = expectations[k];
        hearing.begin(expectation.file);
        std::optional<HeardRecording> known;
        if (hearing.kept != nullptr)
            if (const std::optional<std::string> text = hearing.kept->find(k)) known = unpacked(expectation, *text);
        if (!known) {
            known = hear_recording(expectation, hearing);
            if (hearing.kept != nullptr) hearing.kept->keep(k, packed(*known));
            hearing.progress(1.0);
        }
        heard.push_back(std::move(*known));
        hearing.end();
    }
    return heard;
}

}  // namespace stridor::hearing
