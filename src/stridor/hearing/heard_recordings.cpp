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
#include <map>
#include <memory>
#include <optional>
#include <random>
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

constexpr std::size_t draws = 2000;
constexpr std::uint64_t seed = 16;
constexpr std::array bin_edges{0.0, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0};
constexpr std::array spoken_from{0.0, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};

bool expects(const HeardRecording& recording, Category category) {
    const auto& categories = recording.expectation.categories;
    return std::find(categories.begin(), categories.end(), category) != categories.end();
}

bool is_tone(Category category) {
    return category == Category::squeal || category == Category::squeak;
}

bool expects_only(const HeardRecording& recording, const std::function<bool(Category)>& accepted) {
    const auto& categories = recording.expectation.categories;
    return std::all_of(categories.begin(), categories.end(), accepted);
}

struct Kind {
    const char* what;
    bool (*belongs)(const HeardRecording&);
};

constexpr std::array kinds{
    Kind{"all", [](const HeardRecording&) { return true; }},
    Kind{"sure of the label", [](const HeardRecording& r) { return r.expectation.is_sure; }},
    Kind{"creaks, sure",
         [](const HeardRecording& r) {
             return r.expectation.is_sure && expects(r, Category::creak) && !expects(r, Category::none);
         }},
    Kind{"tones, sure", [](const HeardRecording& r) { return r.expectation.is_sure && expects_only(r, is_tone); }},
    Kind{"none, sure",
         [](const HeardRecording& r) {
             return r.expectation.is_sure && expects_only(r, [](Category c) { return c == Category::none; });
         }},
    Kind{"squeal or squeak, of those heard as tones",
         [](const HeardRecording& r) {
             return r.expectation.categories.size() == 1 && expects_only(r, is_tone) && is_tone(r.heard);
         }},
};

struct Count {
    std::size_t right = 0;
    std::size_t count = 0;
};

RightShare share_of(const Kind& kind, std::span<const HeardRecording> recordings) {
    std::map<std::string, Count> sources;
    RightShare share{kind.what, 0, 0, 0.0, 0.0};
    for (std::size_t k = 0; k < recordings.size(); ++k) {
        const HeardRecording& recording = recordings[k];
        if (!kind.belongs(recording)) continue;
        const std::string& source = recording.expectation.source;
        Count& count = sources[source.empty() ? recording.expectation.file : source];
        ++count.count;
        count.right += is_right(recording) ? 1 : 0;
    }
    std::vector<Count> counts;
    for (const auto& [source, count] : sources) {
        counts.push_back(count);
        share.right += count.right;
        share.count += count.count;
    }
    if (counts.empty()) return share;
    std::mt19937_64 random(seed);
    std::vector<double> drawn;
    for (std::size_t draw = 0; draw < draws; ++draw) {
        Count sum;
        for (std::size_t k = 0; k < counts.size(); ++k) {
            const Count& one = counts[random() % counts.size()];
            sum.right += one.right;
            sum.count += one.count;
        }
        drawn.push_back(static_cast<double>(sum.right) / static_cast<double>(sum.count));
    }
    std::sort(drawn.begin(), drawn.end());
    share.low = drawn[draws / 40];
    share.high = drawn[draws - 1 - draws / 40];
    return share;
}

std::vector<HeardRow> rows_of(std::span<const HeardRecording> recordings) {
    std::vector<HeardRow> rows;
    for (const HeardRecording& recording : recordings) {
        const std::string& words = recording.expectation.words;
        auto row = std::find_if(rows.begin(), rows.end(), [&](const HeardRow& each) { return each.expected == words; });
        if (row == rows.end()) row = rows.insert(rows.end(), {words, {}});
        ++row->heard[static_cast<std::size_t>(recording.heard)];
    }
    return rows;
}

void describe_probabilities(std::span<const HeardRecording> recordings, RecordingScore& score) {
    const auto is_by_ear = [](const HeardRecording& recording) { return recording.probability > 0.0; };
    if (std::none_of(recordings.begin(), recordings.end(), is_by_ear)) return;
    for (std::size_t k = 0; k + 1 < bin_edges.size(); ++k) {
        CalibrationBin bin{bin_edges[k], bin_edges[k + 1], 0, 0, 0.0};
        const bool is_last = k + 2 == bin_edges.size();
        for (const HeardRecording& recording : recordings) {
            const double p = recording.probability;
            if (!is_by_ear(recording) || p < bin.from || (p >= bin.to && !is_last)) continue;
            ++bin.count;
            bin.right += is_right(recording) ? 1 : 0;
            bin.probability += p;
        }
        if (bin.count == 0) continue;
        bin.probability /= static_cast<double>(bin.count);
        score.bins.push_back(bin);
    }
    for (const double least : spoken_from) {
        AbstentionPoint point{least, 0, 0};
        for (const HeardRecording& recording : recordings) {
            if (!is_by_ear(recording) || recording.probability < least) continue;
            ++point.decided;
            point.right += is_right(recording) ? 1 : 0;
        }
        score.decided.push_back(point);
    }
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

RecordingScore score_of(std::span<const HeardRecording> recordings) {
    RecordingScore score;
    for (const Kind& kind : kinds)
        score.shares.push_back(share_of(kind, recordings));
    score.rows = rows_of(recordings);
    describe_probabilities(recordings, score);
    return score;
}

}  // namespace stridor::hearing
