#include "stridor/recordings/live/recorder_words.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/process.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace stridor::recordings {

namespace {

// the one that knows the sound server of the desktop comes first, as PulseAudio's and PipeWire's; ALSA's is everywhere
constexpr std::array<std::string_view, 2> recorders{"parec", "arecord"};

std::string alsa_word(SampleCoding coding) {
    switch (coding) {
        case SampleCoding::u8:
            return "U8";
        case SampleCoding::s16:
            return "S16_LE";
        case SampleCoding::s24:
            return "S24_3LE";
        case SampleCoding::s32:
            return "S32_LE";
        case SampleCoding::f32:
            return "FLOAT_LE";
        case SampleCoding::f64:
            break;
    }
    return "FLOAT64_LE";
}

std::string pulse_word(SampleCoding coding) {
    switch (coding) {
        case SampleCoding::u8:
            return "u8";
        case SampleCoding::s16:
            return "s16le";
        case SampleCoding::s24:
            return "s24le";
        case SampleCoding::s32:
            return "s32le";
        case SampleCoding::f32:
            return "float32le";
        case SampleCoding::f64:
            break;
    }
    throw Error(ErrorKind::input, {"parec sends no f64le", "", "Choose --raw f32le."});
}

// "overrun!!! (at least 12.345 ms long)"
std::optional<double> seconds_in(std::string_view line) {
    constexpr std::string_view before = "at least ";
    const std::size_t place = line.find(before);
    if (place == std::string_view::npos) return std::nullopt;
    const std::string_view rest = line.substr(place + before.size());
    double milliseconds = 0.0;
    const auto [end, failure] = std::from_chars(rest.data(), rest.data() + rest.size(), milliseconds);
    const bool is_told = failure == std::errc() && std::string_view(end, rest.data() + rest.size()).starts_with(" ms");
    return is_told ? std::optional(1e-3 * milliseconds) : std::nullopt;
}

}  // namespace

std::string known_recorders() {
    std::string names;
    for (const std::string_view recorder : recorders)
        names += (names.empty() ? "" : ", ") + std::string(recorder);
    return names;
}

std::string recorder_for(std::string_view device, std::string_view named) {
    if (!named.empty()) {
        if (std::find(recorders.begin(), recorders.end(), named) != recorders.end()) return std::string(named);
        throw Error(ErrorKind::input, {"\"" + std::string(named) + "\" is no known recorder", "",
                                       "Known are " + known_recorders() + "."});
    }
    const bool is_of_alsa = device.find(':') != std::string_view::npos;
    if (is_of_alsa) return base::is_on_path("arecord") ? "arecord" : "";
    for (const std::string_view recorder : recorders)
        if (base::is_on_path(std::string(recorder))) return std::string(recorder);
    return {};
}

std::vector<std::string> recorder_command(const std::string& recorder, const std::string& device,
                                          const StreamForm& form) {
    const std::string rate = std::to_string(std::llround(form.rate));
    const std::string channels = std::to_string(form.channels);
    std::vector<std::string> command{recorder};
    const auto add = [&](std::initializer_list<std::string> words) {
        command.insert(command.end(), words.begin(), words.end());
    };
    if (recorder == "arecord") {
        // buffers as long as the device grants, so that a busy machine loses nothing
        add({"--quiet", "--file-type=raw", "--format=" + alsa_word(form.coding), "--rate=" + rate,
             "--channels=" + channels, "--buffer-time=2000000"});
        if (!device.empty()) add({"--device=" + device});
    } else {
        // it tells what it lost only if it tells all
        add({"--verbose", "--raw", "--format=" + pulse_word(form.coding), "--rate=" + rate, "--channels=" + channels});
        if (!device.empty()) add({"--device=" + device});
    }
    return command;
}

std::optional<LostSound> RecorderWords::hear(std::string_view bytes) {
    constexpr std::size_t most = 2000;  // [bytes] kept
    std::optional<LostSound> lost;
    for (const char c : bytes) {
        if (c != '\n' && c != '\r') {
            if (line_.size() < most) line_ += c;
            continue;
        }
        if (line_.find("verrun") != std::string::npos && !lost)
            lost = LostSound{seconds_in(line_), std::string(base::trimmed(line_))};
        lines_ += line_ + "\n";
        if (lines_.size() > most) lines_.erase(0, lines_.size() - most);
        line_.clear();
    }
    return lost;
}

std::string RecorderWords::last() const {
    // of many lines the last say why it ended
    constexpr std::size_t told = 300;  // [bytes]
    const std::string all(base::trimmed(lines_ + line_));
    return all.size() <= told ? all : "..." + all.substr(all.size() - told);
}

}  // namespace stridor::recordings
