#include "stridor/recordings/audio/wav.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/base/version.hpp"
#include "stridor/recordings/sidecar.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

namespace stridor::recordings {

namespace {

constexpr std::size_t wav_block = 1U << 14U;
constexpr std::uint64_t largest_size = 0xFFFFFFFFU;
constexpr std::size_t description_bytes = 256;
constexpr std::uint64_t long_size_offset = 12;  // [bytes] of the ds64 chunk, or of what keeps its place

std::string little_endian(std::uint64_t value, std::size_t bytes) {
    std::string text;
    for (std::size_t k = 0; k < bytes; ++k)
        text += static_cast<char>(value >> (8U * k) & 0xFFU);
    return text;
}

std::string chunk(std::string_view name, const std::string& content) {
    return std::string(name) + little_endian(content.size(), 4) + content + std::string(content.size() % 2, '\0');
}

std::string padded(std::string_view text, std::size_t width) {
    std::string result(text.substr(0, width));
    result.resize(width, '\0');
    return result;
}

std::uint64_t bytes_of(WavSamples samples) {
    return samples == WavSamples::pcm_16 ? 2 : samples == WavSamples::pcm_24 ? 3 : 4;
}

std::vector<FullScale> full_scales_of(const signal::ChannelLayout& layout, const std::vector<FullScale>& given) {
    std::vector<FullScale> scales;
    const bool fits = given.empty() || given.size() == 1 || given.size() == layout.channels.size();
    if (!fits)
        throw Error(ErrorKind::input, {std::to_string(given.size()) + " full scales for " +
                                           std::to_string(layout.channels.size()) + " channels",
                                       "one for all or one for each is needed", ""});
    for (std::size_t channel = 0; channel < layout.channels.size(); ++channel) {
        const std::string& unit = layout.channels[channel].unit;
        const FullScale scale = given.empty() ? FullScale{1.0, unit} : given[given.size() == 1 ? 0 : channel];
        if (scale.unit != unit)
            throw Error(ErrorKind::input,
                        {"a full scale in " + scale.unit + " does not fit samples in " + unit, "", ""});
        scales.push_back(scale);
    }
    return scales;
}

// one calibration for the whole file, as far as one text can hold it
std::string description_of(const WavOptions& options, const std::vector<FullScale>& scales) {
    const bool is_one =
        std::all_of(scales.begin(), scales.end(), [&](const FullScale& s) { return s == scales.front(); });
    const std::string calibration = is_one ? calibration_text(scales.front()) : "";
    const std::string separator = options.description.empty() || calibration.empty() ? "" : "; ";
    const std::size_t room = description_bytes - std::min(description_bytes, calibration.size() + separator.size());
    return options.description.substr(0, room) + separator + calibration;
}

// what is too long is left out: half a case is none
std::string broadcast_chunk(const std::string& description, const std::string& history) {
    constexpr std::size_t rest = 10 + 8 + 8;  // date, time, reference: not known, and the same bytes every time
    return chunk("bext", padded(description, description_bytes) +
                             padded("Stridor " + std::string(base::version()), 32) + padded("", 32) + padded("", rest) +
                             little_endian(1, 2) + padded("", 64 + 190) +
                             (history.size() <= longest_history ? history : ""));
}

struct Head {
    std::string text;
    std::uint64_t fact_offset = 0;  // [bytes] of the number of frames; 0: none
};

Head head_of(const signal::ChannelLayout& layout, const WavOptions& options, const std::string& description) {
    const std::uint64_t channels = layout.channels.size();
    const auto rate = static_cast<std::uint64_t>(std::llround(layout.rate));
    const std::uint64_t frame_bytes = channels * bytes_of(options.samples);
    const bool is_float = options.samples == WavSamples::float_32;
    std::string format = little_endian(is_float ? 3 : 1, 2) + little_endian(channels, 2) + little_endian(rate, 4) +
                         little_endian(rate * frame_bytes, 4) + little_endian(frame_bytes, 2) +
                         little_endian(8 * bytes_of(options.samples), 2);
    if (is_float) format += little_endian(0, 2);
    Head head;
    head.text = "RIFF" + little_endian(0, 4) + "WAVE" + chunk("JUNK", std::string(28, '\0')) + chunk("fmt ", format);
    if (!description.empty() || !options.history.empty()) head.text += broadcast_chunk(description, options.history);
    if (is_float) {
        head.fact_offset = head.text.size() + 8;
        head.text += chunk("fact", little_endian(0, 4));
    }
    head.text += "data" + little_endian(0, 4);
    return head;
}

/// Samples on their way into the file.
class Encoder {
public:
    explicit Encoder(WavSamples samples) : samples_(samples) {}

    void append(std::string& bytes, double value) {
        if (!std::isfinite(value))
            throw Error(ErrorKind::input, {"a sample is not a finite number", "a WAV file cannot hold it", ""});
        if (samples_ == WavSamples::float_32) return append_float(bytes, value);
        const double top = samples_ == WavSamples::pcm_16 ? 32768.0 : 8388608.0;
        const double scaled = std::nearbyint(value * top);
        const double kept = std::clamp(scaled, -top, top - 1.0);
        // 1.0 itself lies one step beyond the largest number: nobody calls that clipping
        clipped_ += scaled != kept && scaled != top ? 1 : 0;
        const auto number = static_cast<std::uint64_t>(static_cast<std::int64_t>(kept));
        for (std::uint64_t byte = 0; byte < bytes_of(samples_); ++byte)
            bytes += static_cast<char>(number >> (8U * byte) & 0xFFU);
    }

    std::uint64_t clipped() const { return clipped_; }

private:
    static void append_float(std::string& bytes, double value) {
        if (std::abs(value) > static_cast<double>(std::numeric_limits<float>::max()))
            throw Error(ErrorKind::input, {"a sample is too large for single precision", "", "Give a full scale."});
        bytes += little_endian(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
    }

    WavSamples samples_;
    std::uint64_t clipped_ = 0;
};

void patch_sizes(storage::PiecewiseFile& file, const Head& head, std::uint64_t data_bytes, std::uint64_t frames) {
    const std::uint64_t riff_bytes = file.size() - 8;
    const bool is_long = riff_bytes > largest_size;
    if (is_long) {
        file.overwrite(0, "RF64");
        file.overwrite(long_size_offset, "ds64" + little_endian(28, 4) + little_endian(riff_bytes, 8) +
                                             little_endian(data_bytes, 8) + little_endian(frames, 8));
    }
    file.overwrite(4, little_endian(is_long ? largest_size : riff_bytes, 4));
    file.overwrite(head.text.size() - 4, little_endian(is_long ? largest_size : data_bytes, 4));
    if (head.fact_offset > 0) file.overwrite(head.fact_offset, little_endian(std::min(frames, largest_size), 4));
}

Sidecar sidecar_of(const signal::ChannelLayout& layout, const std::vector<FullScale>& scales) {
    Sidecar sidecar;
    const bool is_whole = layout.rate == std::round(layout.rate);
    if (!is_whole) sidecar.rate = layout.rate;
    for (std::size_t channel = 0; channel < scales.size(); ++channel) {
        SidecarChannel entry;
        if (!layout.channels[channel].name.empty()) entry.name = layout.channels[channel].name;
        const bool is_calibrated = scales[channel].unit != signal::full_scale || scales[channel].value != 1.0;
        if (is_calibrated) entry.full_scale = scales[channel];
        sidecar.channels.push_back(entry);
    }
    return sidecar;
}

bool says_anything(const Sidecar& sidecar) {
    return sidecar.rate ||
           std::any_of(sidecar.channels.begin(), sidecar.channels.end(),
                       [](const SidecarChannel& channel) { return channel.name || channel.full_scale; });
}

void check_rate(double rate) {
    const bool fits = rate >= 1.0 && rate <= 4294967295.0;
    if (!fits)
        throw Error(ErrorKind::input, {"a WAV file cannot have a rate of " + base::shortest(rate) + " Hz",
                                       "it holds whole numbers from 1 Hz on", "Write CSV or UFF."});
}

// a file that only has a sidecar's name is not ours to replace
void check_sidecar(const std::string& recording) {
    const std::string path = sidecar_path(recording);
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0) parse_sidecar(storage::read_file(path), path);
}

void remove_sidecar(const std::string& recording) {
    const std::string path = sidecar_path(recording);
    if (::unlink(path.c_str()) == 0 || errno == ENOENT || errno == ENOTDIR) return;
    throw Error(ErrorKind::io, {"cannot remove the old sidecar \"" + path + "\"", std::strerror(errno), ""});
}

}  // namespace

WavWritten write_wav(const std::string& path, signal::Source& source, const WavOptions& options) {
    const signal::ChannelLayout& layout = source.layout();
    check_rate(layout.rate);
    const std::vector<FullScale> scales = full_scales_of(layout, options.full_scales);
    check_sidecar(path);
    storage::PiecewiseFile file(path);
    const Head head = head_of(layout, options, description_of(options, scales));
    file.write(head.text);

    const std::size_t width = scales.size();
    std::vector<double> block(wav_block * width);
    Encoder encoder(options.samples);
    std::string bytes;
    WavWritten written;
    while (const std::size_t count = source.read(block)) {
        bytes.clear();
        for (std::size_t k = 0; k < count * width; ++k)
            encoder.append(bytes, block[k] / scales[k % width].value);
        file.write(bytes);
        written.frames += count;
    }
    written.clipped = encoder.clipped();
    const std::uint64_t data_bytes = written.frames * width * bytes_of(options.samples);
    if (data_bytes % 2 == 1) file.write(std::string_view("\0", 1));
    patch_sizes(file, head, data_bytes, written.frames);

    // whatever happens in between, no calibration of one recording ever stands beside another
    remove_sidecar(path);
    file.commit();
    const Sidecar sidecar = sidecar_of(layout, scales);
    if (says_anything(sidecar)) storage::write_file(sidecar_path(path), sidecar_json(sidecar));
    return written;
}

std::string wav_bytes(const signal::Signal& signal, const FullScale& scale) {
    check_rate(signal.rate);
    const signal::ChannelLayout layout{signal.rate, {{"", signal.unit}}, signal.samples.size()};
    const WavOptions options{WavSamples::pcm_16, {scale}};
    const Head head = head_of(layout, options, description_of(options, full_scales_of(layout, {scale})));
    std::string bytes = head.text;
    Encoder encoder(options.samples);
    for (const double sample : signal.samples)
        encoder.append(bytes, sample / scale.value);
    const std::uint64_t data_bytes = bytes.size() - head.text.size();
    STRIDOR_EXPECT(bytes.size() <= largest_size);
    bytes.replace(4, 4, little_endian(bytes.size() - 8, 4));
    bytes.replace(head.text.size() - 4, 4, little_endian(data_bytes, 4));
    return bytes;
}

}  // namespace stridor::recordings
