#include "stridor/recordings/audio/ffmpeg_source.hpp"

#include "stridor/base/check.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace stridor::recordings {

namespace {

constexpr std::size_t largest_piece = std::size_t{1} << 28U;  // [bytes] of memory

struct SetUpFfmpeg : Ffmpeg {
    const bool is_whole = avformat.is_whole() && avcodec.is_whole() && avutil.is_whole() && swresample.is_whole();

    SetUpFfmpeg() {
        if (!is_whole) return;
        av_log_set_level(AV_LOG_QUIET);
        av_max_alloc(largest_piece);
        // assembly for one processor or another rounds otherwise
        av_force_cpu_flags(0);
    }
};

// what phones and browsers record with
constexpr std::array known_codecs{
    AV_CODEC_ID_AAC,       AV_CODEC_ID_ALAC,      AV_CODEC_ID_AMR_NB,    AV_CODEC_ID_AMR_WB,    AV_CODEC_ID_OPUS,
    AV_CODEC_ID_VORBIS,    AV_CODEC_ID_MP3,       AV_CODEC_ID_FLAC,      AV_CODEC_ID_PCM_S16LE, AV_CODEC_ID_PCM_S16BE,
    AV_CODEC_ID_PCM_S24LE, AV_CODEC_ID_PCM_S24BE, AV_CODEC_ID_PCM_S32LE, AV_CODEC_ID_PCM_F32LE};

constexpr int io_buffer = 1 << 15;                    // [bytes]
constexpr int most_channels = 64;                     // [1]
constexpr int highest_rate = 768000;                  // [Hz]
constexpr std::int64_t most_per_frame = 1 << 18;      // [1] samples of a channel that a decoder may make of one packet
constexpr int most_silent_packets = 10000;            // [1] one after the other that give no sample
constexpr std::uint64_t most_frames_per_byte = 8192;  // [1] frames; a byte of Opus can stand for 5760
constexpr std::uint64_t largest_shortfall = 8192;     // [1] frames that the length in a file may be off: a few packets
constexpr const char* probe_size = "1048576";         // [bytes] that a demuxer looks at before it begins
constexpr const char* most_streams = "32";            // [1]

template <auto member>
struct Free {
    const Ffmpeg* ffmpeg;
    template <typename T>
    void operator()(T* thing) const {
        (ffmpeg->*member)(&thing);
    }
};

/// Where ffmpeg is in the file.
struct Cursor {
    std::shared_ptr<const Bytes> bytes;
    std::uint64_t position = 0;
};

// no exception may cross the library
int read_bytes(void* user, std::uint8_t* into, int count) {
    Cursor& cursor = *static_cast<Cursor*>(user);
    try {
        const std::size_t done =
            cursor.bytes->read_at(cursor.position, {reinterpret_cast<char*>(into), static_cast<std::size_t>(count)});
        cursor.position += done;
        return done == 0 ? AVERROR_EOF : static_cast<int>(done);
    } catch (const Error&) {
        return AVERROR(EIO);
    }
}

std::int64_t seek(void* user, std::int64_t offset, int whence) {
    Cursor& cursor = *static_cast<Cursor*>(user);
    const auto size = static_cast<std::int64_t>(cursor.bytes->size());
    if (whence == AVSEEK_SIZE) return size;
    const std::int64_t from = whence == SEEK_SET   ? 0
                              : whence == SEEK_CUR ? static_cast<std::int64_t>(cursor.position)
                                                   : size;
    if (offset > size || from + offset < 0 || from + offset > size) return AVERROR(EINVAL);
    cursor.position = static_cast<std::uint64_t>(from + offset);
    return from + offset;
}

// a file may name others; none is opened
int refuse_to_open(AVFormatContext*, AVIOContext**, const char*, int, AVDictionary**) {
    return AVERROR(EPERM);
}

class FfmpegSource final : public signal::Source {
public:
    FfmpegSource(const Ffmpeg& ffmpeg, const SignalInput& input, const std::string& demuxer)
        : ffmpeg_(ffmpeg),
          name_(input.name),
          cursor_{input.bytes, 0},
          packet_(ffmpeg.av_packet_alloc(), {&ffmpeg}),
          frame_(ffmpeg.av_frame_alloc(), {&ffmpeg}) {
        open_file(demuxer);
        open_stream();
        // only a decoded frame tells the rate and the channels: extensions of AAC double them
        if (!decode()) throw refusal(name_, "the sound file holds no samples");
        layout_.rate = frame_->sample_rate;
        layout_.channels.assign(static_cast<std::size_t>(frame_->ch_layout.nb_channels), {"", ""});
        open_conversion();
        take_frame();
    }

    const signal::ChannelLayout& layout() const override { return layout_; }

    std::size_t read(std::span<double> frames) override {
        const std::size_t width = layout_.channels.size();
        STRIDOR_EXPECT(frames.size() % width == 0);
        std::size_t done = 0;
        while (done < frames.size()) {
            if (taken_ == samples_.size()) {
                if (!decode()) break;
                take_frame();
            }
            const std::size_t count = std::min(frames.size() - done, samples_.size() - taken_);
            std::copy_n(samples_.begin() + static_cast<std::ptrdiff_t>(taken_), count,
                        frames.begin() + static_cast<std::ptrdiff_t>(done));
            taken_ += count;
            done += count;
        }
        return done / width;
    }

    const AVFormatContext& file() const { return *file_; }
    std::string codec() const { return ffmpeg_.avcodec_get_name(decoder_->codec_id); }

private:
    struct FreeIo {
        const Ffmpeg* ffmpeg;
        void operator()(AVIOContext* io) const {
            ffmpeg->av_free(io->buffer);
            ffmpeg->avio_context_free(&io);
        }
    };

    std::string why(int code) const {
        std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
        ffmpeg_.av_strerror(code, text.data(), text.size());
        return text.data();
    }

    Error damaged(int code) const {
        return refusal(name_, "the sound file is damaged after " + std::to_string(frames_) + " frames", why(code));
    }

    void open_file(const std::string& demuxer) {
        const AVInputFormat* format = ffmpeg_.av_find_input_format(demuxer.c_str());
        if (format == nullptr) throw refusal(name_, "ffmpeg's libraries here do not read " + demuxer);
        auto* buffer = static_cast<unsigned char*>(ffmpeg_.av_malloc(io_buffer));
        io_ = {ffmpeg_.avio_alloc_context(buffer, io_buffer, 0, &cursor_, read_bytes, nullptr, seek), {&ffmpeg_}};
        AVFormatContext* context = ffmpeg_.avformat_alloc_context();
        context->pb = io_.get();
        context->io_open = refuse_to_open;
        AVDictionary* options = nullptr;
        for (const auto& [key, value] : {std::pair{"protocol_whitelist", "none"}, std::pair{"probesize", probe_size},
                                         std::pair{"max_streams", most_streams}})
            ffmpeg_.av_dict_set(&options, key, value, 0);
        // it frees the context where it fails
        const int code = ffmpeg_.avformat_open_input(&context, "", format, &options);
        ffmpeg_.av_dict_free(&options);
        file_ = {context, {&ffmpeg_}};
        if (code >= 0) return;
        throw refusal(name_, "the sound file cannot be read", why(code), "Is it damaged or cut off?");
    }

    void open_stream() {
        for (unsigned k = 0; k < file_->nb_streams; ++k) {
            AVStream* stream = file_->streams[k];
            const bool is_sound = stream->codecpar->codec_type == AVMEDIA_TYPE_AUDIO;
            if (is_sound && stream_ == nullptr) stream_ = stream;
            if (stream != stream_) stream->discard = AVDISCARD_ALL;
        }
        if (stream_ == nullptr) throw refusal(name_, "the file holds no sound");
        const AVCodecID id = stream_->codecpar->codec_id;
        const bool is_known = std::find(known_codecs.begin(), known_codecs.end(), id) != known_codecs.end();
        const AVCodec* codec = is_known ? ffmpeg_.avcodec_find_decoder(id) : nullptr;
        if (codec == nullptr)
            throw refusal(name_, "the sound is coded as " + std::string(ffmpeg_.avcodec_get_name(id)),
                          "that is not read here", "Convert it first: ffmpeg -i IN OUT.wav");
        decoder_ = {ffmpeg_.avcodec_alloc_context3(codec), {&ffmpeg_}};
        const int code = ffmpeg_.avcodec_parameters_to_context(decoder_.get(), stream_->codecpar);
        if (code < 0) throw damaged(code);
        decoder_->thread_count = 1;
        decoder_->pkt_timebase = stream_->time_base;
        decoder_->max_samples = most_per_frame;
        if (const int opened = ffmpeg_.avcodec_open2(decoder_.get(), codec, nullptr); opened < 0) throw damaged(opened);
    }

    void open_conversion() {
        SwrContext* conversion = nullptr;
        AVChannelLayout* channels = &frame_->ch_layout;
        int code =
            ffmpeg_.swr_alloc_set_opts2(&conversion, channels, AV_SAMPLE_FMT_DBL, frame_->sample_rate, channels,
                                        static_cast<AVSampleFormat>(frame_->format), frame_->sample_rate, 0, nullptr);
        conversion_ = {conversion, {&ffmpeg_}};
        if (code >= 0) code = ffmpeg_.swr_init(conversion);
        if (code < 0) throw damaged(code);
        format_ = frame_->format;
    }

    // the next samples into frame_; false at the end
    bool decode() {
        for (int silent = 0; silent < most_silent_packets; ++silent) {
            const int code = ffmpeg_.avcodec_receive_frame(decoder_.get(), frame_.get());
            if (code == 0 && frame_->nb_samples > 0) return check_frame();
            if (code == AVERROR_EOF) return check_end();
            if (code < 0 && code != AVERROR(EAGAIN)) throw damaged(code);
            if (code < 0) feed();
        }
        throw refusal(name_, "the sound file is damaged after " + std::to_string(frames_) + " frames",
                      "thousands of packets without a sample follow");
    }

    void feed() {
        int code = ffmpeg_.av_read_frame(file_.get(), packet_.get());
        if (code >= 0 && packet_->stream_index != stream_->index) {
            ffmpeg_.av_packet_unref(packet_.get());
            return;
        }
        if (code < 0 && code != AVERROR_EOF) throw damaged(code);
        code = ffmpeg_.avcodec_send_packet(decoder_.get(), code < 0 ? nullptr : packet_.get());
        ffmpeg_.av_packet_unref(packet_.get());
        if (code < 0 && code != AVERROR_EOF) throw damaged(code);
    }

    bool check_frame() {
        const int channels = frame_->ch_layout.nb_channels;
        const bool is_sound =
            channels > 0 && channels <= most_channels && frame_->sample_rate > 0 && frame_->sample_rate <= highest_rate;
        if (!is_sound)
            throw refusal(name_,
                          "the sound has " + std::to_string(channels) + " channels at " +
                              std::to_string(frame_->sample_rate) + " Hz",
                          "Is its header damaged?");
        const bool is_first = conversion_ == nullptr;
        const bool is_same = static_cast<std::size_t>(channels) == layout_.channels.size() &&
                             frame_->sample_rate == static_cast<int>(layout_.rate) && frame_->format == format_;
        if (!is_first && !is_same)
            throw refusal(name_, "the sound changes its rate or channels after " + std::to_string(frames_) + " frames");
        frames_ += static_cast<std::uint64_t>(frame_->nb_samples);
        if (frames_ / most_frames_per_byte > cursor_.bytes->size())
            throw refusal(name_, "the sound is longer than its bytes can hold", "", "Is it damaged?");
        return true;
    }

    bool check_end() const {
        if (stream_->duration == AV_NOPTS_VALUE || stream_->time_base.den <= 0) return false;
        const double seconds = static_cast<double>(stream_->duration) * stream_->time_base.num / stream_->time_base.den;
        const double expected = seconds * layout_.rate;
        if (frames_ > 0 && expected > static_cast<double>(frames_ + largest_shortfall))
            throw refusal(name_, "the sound file ends after " + std::to_string(frames_) + " frames",
                          "it should last " + std::to_string(seconds) + " s: it is damaged or cut off");
        return false;
    }

    void take_frame() {
        const auto count = static_cast<std::size_t>(frame_->nb_samples);
        samples_.resize(count * layout_.channels.size());
        auto* into = reinterpret_cast<std::uint8_t*>(samples_.data());
        const int done =
            ffmpeg_.swr_convert(conversion_.get(), &into, frame_->nb_samples,
                                const_cast<const std::uint8_t**>(frame_->extended_data), frame_->nb_samples);
        if (done != frame_->nb_samples) throw damaged(std::min(done, -1));
        taken_ = 0;
    }

    const Ffmpeg& ffmpeg_;
    std::string name_;
    Cursor cursor_;
    std::unique_ptr<AVIOContext, FreeIo> io_{nullptr, {nullptr}};
    std::unique_ptr<AVFormatContext, Free<&Ffmpeg::avformat_close_input>> file_{nullptr, {nullptr}};
    std::unique_ptr<AVCodecContext, Free<&Ffmpeg::avcodec_free_context>> decoder_{nullptr, {nullptr}};
    std::unique_ptr<SwrContext, Free<&Ffmpeg::swr_free>> conversion_{nullptr, {nullptr}};
    std::unique_ptr<AVPacket, Free<&Ffmpeg::av_packet_free>> packet_;
    std::unique_ptr<AVFrame, Free<&Ffmpeg::av_frame_free>> frame_;
    AVStream* stream_ = nullptr;
    int format_ = -1;  // of the samples, as they are decoded
    signal::ChannelLayout layout_;
    std::vector<double> samples_;  // shape [frame][channel], of the last packet
    std::size_t taken_ = 0;        // of them
    std::uint64_t frames_ = 0;     // decoded so far
};

}  // namespace

const Ffmpeg* ffmpeg_library() {
    static const SetUpFfmpeg opened;
    return opened.is_whole ? &opened : nullptr;
}

RawSignal open_with_ffmpeg(const Ffmpeg& ffmpeg, const SignalInput& input, const std::string& kind,
                           const std::string& demuxer) {
    auto source = std::make_unique<FfmpegSource>(ffmpeg, input, demuxer);
    RawSignal raw;
    raw.format = kind + ", " + source->codec();
    for (const char* key : {"title", "artist", "date", "creation_time", "comment"})
        if (const AVDictionaryEntry* tag = ffmpeg.av_dict_get(source->file().metadata, key, nullptr, 0))
            raw.metadata.emplace_back(key, tag->value);
    for (const auto& [key, text] : raw.metadata)
        if (key == "comment") raw.description = text;
    raw.source = std::move(source);
    return raw;
}

}  // namespace stridor::recordings
