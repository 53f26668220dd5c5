#include "sounds/live_input.hpp"

#include "arguments.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/console/results/text_table.hpp"
#include "stridor/recordings/bytes.hpp"
#include "stridor/recordings/live/recorder_words.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace stridor::app {

namespace {

constexpr std::size_t block_bytes = 1U << 16U;

recordings::StreamForm form_of(const LiveInputOptions& options) {
    recordings::StreamForm form;
    form.coding = at_option("--raw", options.coding, [&] { return recordings::sample_coding_of(options.coding); });
    form.rate = base::parse_quantity(options.rate, "Hz");
    form.channels = static_cast<std::size_t>(options.channels);
    return form;
}

Error no_head(const std::string& name) {
    return {ErrorKind::input,
            {name + " is no WAV stream", "it does not begin with RIFF, RF64 or BW64",
             "If these are bare samples, say which: --raw s16le --rate 48000 --channels 1. Other formats become WAV on "
             "the way: ffmpeg -i IN -f wav - | stridor listen-in"}};
}

// a chunk of text behind the samples of a file that is whole: a name of four letters, and a length that fits
bool is_chunk(std::string_view bytes, std::uint64_t left) {
    if (bytes.size() < 8) return false;
    const bool has_name = std::all_of(bytes.begin(), bytes.begin() + 4, [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == ' ' || c == '_';
    });
    std::uint64_t size = 0;
    for (std::size_t k = 8; k-- > 4;)
        size = size << 8U | static_cast<unsigned char>(bytes[k]);
    return has_name && size + 8 <= left;
}

}  // namespace

void add_live_input_options(CLI::App& command, LiveInputOptions& options) {
    command.add_option("file", options.file, "standard input (-), or with --follow a WAV file that is being written");
    command.add_flag("--follow", options.follows, "listen to what another program adds to the file");
    CLI::Option* device = command.add_option("--device", options.device,
                                             "record from this device: hw:1,0 of ALSA, or a source of PulseAudio or "
                                             "PipeWire; \"default\" for the usual one");
    device->type_name("NAME")->each([&options](const std::string&) { options.has_device = true; });
    command.add_option("--recorder", options.recorder, "the program that records: parec or arecord")
        ->type_name("PROGRAM");
    command.add_option("--raw", options.coding, "bare samples of this form, and no WAV")
        ->check(one_of(recordings::sample_coding_names()))
        ->type_name("FORM");
    command.add_option("--rate", options.rate, "sampling rate of bare samples, or of the device (default: 48000 Hz)")
        ->type_name("HZ");
    command.add_option("--channels", options.channels, "channels of bare samples, or of the device (default: 1)")
        ->check(CLI::Range(1, 64));
    command.add_option("--channel", options.channel, "this channel alone: its number from 1")->type_name("NUMBER");
    command
        .add_option("--full-scale", options.full_scales,
                    "what the number 1 stands for: \"2 Pa\"; once, or once per channel")
        ->type_name("QUANTITY")
        ->allow_extra_args(false);
}

LiveSamples::LiveSamples(const LiveInputOptions& options, const std::stop_token& stop) {
    open(options);
    if (!options.coding.empty() || is_of_device_) {
        LiveInputOptions raw = options;
        if (raw.coding.empty()) raw.coding = "s16le";
        form_ = form_of(raw);
    } else {
        read_head(stop);
    }
    describe(options);
}

void LiveSamples::open(const LiveInputOptions& options) {
    if (options.has_device && options.file != "-")
        throw Error(ErrorKind::input,
                    {"--device and a file at a time", "one sound is heard", "Leave one of them out."});
    if (options.has_device) {
        const std::string device = options.device == "default" ? "" : options.device;
        const std::string recorder = recordings::recorder_for(device, options.recorder);
        if (recorder.empty())
            throw Error(ErrorKind::io,
                        {"no program that records is installed", "looked for " + recordings::known_recorders(),
                         "apt-get install alsa-utils (arecord: ALSA), or pulseaudio-utils (parec: PulseAudio and "
                         "PipeWire)"});
        LiveInputOptions raw = options;
        if (raw.coding.empty()) raw.coding = "s16le";
        flow_ = recordings::flow_of_program(recordings::recorder_command(recorder, device, form_of(raw)));
        input_.name = recorder + (device.empty() ? "" : " " + device);
        is_of_device_ = true;
        return;
    }
    if (options.file == "-") {
        if (options.follows)
            throw Error(ErrorKind::input, {"--follow needs a file", "standard input is followed anyway", ""});
        if (::isatty(STDIN_FILENO) == 1)
            throw Error(ErrorKind::input, {"there is nothing to listen to", "standard input is this terminal",
                                           "Name a --device, or send a sound: arecord -f S16_LE -r 48000 | stridor "
                                           "listen-in"});
        flow_ = recordings::flow_of_descriptor(STDIN_FILENO);
        input_.name = "standard input";
        return;
    }
    if (!options.follows)
        throw Error(ErrorKind::input, {"\"" + options.file + "\" is a file", "listen-in hears what is not over",
                                       "`stridor classify " + options.file +
                                           "` hears a whole one; --follow listens to one that is being written."});
    flow_ = recordings::flow_of_growing_file(options.file);
    input_.name = growing_file_ = options.file;
    is_growing_ = true;
}

void LiveSamples::read_head(const std::stop_token& stop) {
    std::array<char, 4096> block{};
    for (;;) {
        if (stop.stop_requested()) throw Error(ErrorKind::interrupted, {"stopped before the sound began", "", ""});
        const recordings::Arrival arrival = flow_->next(block, std::chrono::milliseconds(100));
        if (arrival.kind == recordings::Arrival::Kind::end)
            throw Error(ErrorKind::input, {input_.name + " ended before its first sample",
                                           pending_.empty() ? "nothing came" : "its head is not whole", ""});
        pending_.append(block.data(), arrival.count);
        if (pending_.size() >= 4 && !recordings::is_wav_stream(pending_)) throw no_head(input_.name);
        if (pending_.size() < 12) continue;
        head_ = recordings::wav_stream_head(pending_, input_.name);
        if (head_) break;
    }
    form_ = head_->form;
    pending_.erase(0, head_->bytes);
}

void LiveSamples::describe(const LiveInputOptions& options) {
    input_.format = (head_ ? "WAV, " : "") + recordings::stream_form_text(form_);
    input_.layout.rate = form_.rate;
    std::vector<recordings::FullScale> scales = recordings::parse_full_scales(options.full_scales);
    if (scales.size() > 1 && scales.size() != form_.channels)
        throw Error(ErrorKind::input, {fmt::format("{} full scales for {}", scales.size(),
                                                   console::counted(form_.channels, "channel", "channels")),
                                       "one for all or one for each is needed", ""});
    if (scales.empty())
        scales.push_back(recordings::calibration_in(head_ ? head_->description : "").value_or(recordings::FullScale{}));
    scales.resize(form_.channels, scales.front());
    signal::ChannelLayout all{form_.rate, {}, {}};
    for (const recordings::FullScale& scale : scales)
        all.channels.push_back({"", scale.unit});
    for (std::size_t k = 0; k < form_.channels; ++k)
        picked_.push_back(k);
    if (!options.channel.empty()) picked_ = {signal::channel_named(all, options.channel)};
    for (const std::size_t k : picked_) {
        input_.layout.channels.push_back(all.channels[k]);
        full_scales_.push_back(scales[k]);
    }
}

recordings::WavSamples LiveSamples::clip_samples() const {
    using recordings::SampleCoding;
    if (form_.coding == SampleCoding::u8 || form_.coding == SampleCoding::s16) return recordings::WavSamples::pcm_16;
    return form_.coding == SampleCoding::s24 ? recordings::WavSamples::pcm_24 : recordings::WavSamples::float_32;
}

LivePiece LiveSamples::next(std::chrono::milliseconds longest) {
    if (pending_.size() >= form_.frame_bytes()) return piece_of_pending();
    std::array<char, block_bytes> block{};
    recordings::Arrival arrival = flow_->next(block, longest);
    switch (arrival.kind) {
        case recordings::Arrival::Kind::nothing:
            return {};
        case recordings::Arrival::Kind::lost:
            return {LivePiece::Kind::lost, {}, arrival.seconds, std::move(arrival.words), false};
        case recordings::Arrival::Kind::end: {
            LivePiece piece = ending(std::move(arrival.words));
            // a growing file that is cut, removed or replaced: nobody knows what else was written
            piece.is_cut = piece.is_cut || is_growing_;
            return piece;
        }
        case recordings::Arrival::Kind::bytes:
            break;
    }
    pending_.append(block.data(), arrival.count);
    if (!head_ && taken_ == 0 && pending_.size() >= 4 && recordings::is_wav_stream(pending_))
        throw Error(ErrorKind::input, {input_.name + " is a WAV stream and no bare samples",
                                       "it begins with " + pending_.substr(0, 4), "Leave out --raw."});
    return pending_.size() >= form_.frame_bytes() ? piece_of_pending() : LivePiece{};
}

LivePiece LiveSamples::piece_of_pending() {
    const std::size_t width = form_.frame_bytes();
    std::size_t count = pending_.size() / width;
    if (head_ && head_->promised) {
        const std::uint64_t left = (std::max(*head_->promised, taken_) - taken_) / width;
        if (left > 0)
            count = static_cast<std::size_t>(std::min<std::uint64_t>(count, left));
        else if (!is_growing_)
            return ending("its head promised no more");
        else if (is_chunk(pending_, bytes_left()))
            return ending("the file is whole");
    }
    LivePiece piece{LivePiece::Kind::samples, {}, {}, {}, false};
    std::vector<double> samples(count * form_.channels);
    recordings::decode(form_, std::span(pending_).first(count * width), samples);
    pending_.erase(0, count * width);
    taken_ += count * width;
    piece.frames.reserve(count * picked_.size());
    for (std::size_t frame = 0; frame < count; ++frame)
        for (std::size_t k = 0; k < picked_.size(); ++k)
            piece.frames.push_back(samples[frame * form_.channels + picked_[k]] * full_scales_[k].value);
    return piece;
}

// [bytes] of the growing file from the next sample on
std::uint64_t LiveSamples::bytes_left() const {
    std::error_code failure;
    const std::uintmax_t size = std::filesystem::file_size(growing_file_, failure);
    const std::uint64_t heard = head_->bytes + taken_;
    return failure || size < heard ? 0 : size - heard;
}

bool LiveSamples::is_whole() const {
    if (!is_growing_) return false;
    constexpr std::size_t longest_head = 1U << 20U;
    const std::string bytes = recordings::text_at(*recordings::open_bytes(growing_file_), 0, longest_head);
    const auto head = recordings::wav_stream_head(bytes, growing_file_);
    return head && head->bytes == head_->bytes && head->promised == std::optional(taken_);
}

LivePiece LiveSamples::ending(std::string words) {
    LivePiece piece{LivePiece::Kind::end, {}, {}, std::move(words), false};
    const bool is_short = !is_growing_ && head_ && head_->promised && taken_ + form_.frame_bytes() <= *head_->promised;
    const std::size_t odd = pending_.size() % form_.frame_bytes();
    if (is_short)
        piece.words =
            fmt::format("{}: it was cut, {} of {} bytes of samples came", piece.words, taken_ + odd, *head_->promised);
    else if (odd > 0 && !(head_ && head_->promised))
        piece.words = fmt::format("{}, with {} of a frame of {} left over", piece.words,
                                  console::counted(odd, "byte", "bytes"), form_.frame_bytes());
    else
        return piece;
    piece.is_cut = true;
    return piece;
}

}  // namespace stridor::app
