#include "stridor/recordings/audio/audio.hpp"

#include "stridor/base/check.hpp"
#include "stridor/recordings/audio/compressed_audio.hpp"
#include "stridor/recordings/audio/riff.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <sndfile.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>

namespace stridor::recordings {

namespace {

constexpr double lowest_rate = 1.0;   // [Hz]
constexpr double highest_rate = 1e8;  // [Hz] beyond any converter; headers full of noise claim more
constexpr std::uint64_t most_samples_per_byte =
    65536;  // [1] samples that a byte of a packed format can stand for at best

/// The file as libsndfile sees it.
struct Cursor {
    std::shared_ptr<const Bytes> bytes;
    std::uint64_t position = 0;
};

Cursor& cursor_of(void* user) {
    return *static_cast<Cursor*>(user);
}

sf_count_t length_of(void* user) {
    return static_cast<sf_count_t>(cursor_of(user).bytes->size());
}

sf_count_t seek(sf_count_t offset, int whence, void* user) {
    Cursor& cursor = cursor_of(user);
    const sf_count_t from = whence == SEEK_SET   ? 0
                            : whence == SEEK_CUR ? static_cast<sf_count_t>(cursor.position)
                                                 : length_of(user);
    const sf_count_t target = std::clamp<sf_count_t>(from + offset, 0, length_of(user));
    cursor.position = static_cast<std::uint64_t>(target);
    return target;
}

sf_count_t read_bytes(void* into, sf_count_t count, void* user) {
    Cursor& cursor = cursor_of(user);
    if (count <= 0) return 0;
    try {
        const std::size_t done =
            cursor.bytes->read_at(cursor.position, {static_cast<char*>(into), static_cast<std::size_t>(count)});
        cursor.position += done;
        return static_cast<sf_count_t>(done);
    } catch (const Error&) {
        return 0;  // no exception may cross the library, which takes it for the end of the file
    }
}

sf_count_t write_bytes(const void*, sf_count_t, void*) {
    return 0;
}

sf_count_t tell(void* user) {
    return static_cast<sf_count_t>(cursor_of(user).position);
}

struct Closer {
    void operator()(SNDFILE* file) const { sf_close(file); }
};

// most encoders put the number of frames into a first one that holds no sound (Xing, Info, VBRI), behind the tags;
// without it libsndfile guesses it from the size of the file
bool tells_length(const Bytes& bytes) {
    std::uint64_t offset = 0;
    if (const std::string tag = text_at(bytes, 0, 10); tag.size() == 10 && tag.starts_with("ID3")) {
        for (std::size_t k = 6; k < 10; ++k)
            offset = offset << 7U | (static_cast<unsigned char>(tag[k]) & 0x7FU);
        offset += 10;
    }
    constexpr std::size_t first_frame = 1500;  // [bytes] no frame of layer III is longer
    const std::string frame = text_at(bytes, offset, first_frame);
    return frame.find("Xing") != std::string::npos || frame.find("Info") != std::string::npos ||
           frame.find("VBRI") != std::string::npos;
}

class Audio final : public signal::Source {
public:
    explicit Audio(const SignalInput& input) : name_(input.name), cursor_{input.bytes, 0} {
        SF_VIRTUAL_IO door{length_of, seek, read_bytes, write_bytes, tell};
        file_.reset(sf_open_virtual(&door, SFM_READ, &info_, &cursor_));
        if (!file_)
            throw refusal(name_, "the sound file cannot be read", sf_strerror(nullptr), "Is it damaged or cut off?");
        check_claims(input.bytes->size());
        layout_.rate = info_.samplerate;
        layout_.channels.assign(static_cast<std::size_t>(info_.channels), {"", ""});
    }

    const signal::ChannelLayout& layout() const override { return layout_; }

    std::size_t read(std::span<double> frames) override {
        const std::size_t width = layout_.channels.size();
        STRIDOR_EXPECT(frames.size() % width == 0);
        const sf_count_t wanted = static_cast<sf_count_t>(frames.size() / width);
        sf_count_t done = 0;
        while (done < wanted) {
            const sf_count_t count =
                sf_readf_double(file_.get(), frames.data() + static_cast<std::size_t>(done) * width, wanted - done);
            if (count <= 0) break;
            done += count;
        }
        frames_ += static_cast<std::uint64_t>(done);
        if (done < wanted) check_end();
        return static_cast<std::size_t>(done);
    }

    int format() const { return info_.format; }
    SNDFILE* handle() const { return file_.get(); }

private:
    void check_claims(std::uint64_t size) {
        const bool has_rate = info_.samplerate >= lowest_rate && info_.samplerate <= highest_rate;
        if (!has_rate)
            throw refusal(name_, "the sound file has a rate of " + std::to_string(info_.samplerate) + " Hz",
                          "1 Hz to 100 MHz are read", "Is its header damaged?");
        if (info_.channels < 1) throw refusal(name_, "the sound file has no channel");
        if (info_.frames == 0) throw refusal(name_, "the sound file holds no samples");
        const bool is_known = (info_.format & SF_FORMAT_TYPEMASK) != SF_FORMAT_MPEG || tells_length(*cursor_.bytes);
        const bool is_credible =
            is_known && info_.frames > 0 && static_cast<std::uint64_t>(info_.frames) / most_samples_per_byte <= size;
        if (is_credible) layout_.frames = static_cast<std::uint64_t>(info_.frames);
    }

    void check_end() const {
        if (sf_error(file_.get()) != SF_ERR_NO_ERROR)
            throw refusal(name_, "the sound file is damaged after " + std::to_string(frames_) + " frames",
                          sf_strerror(file_.get()));
        if (frames_ == 0) throw refusal(name_, "the sound file holds no samples");
        if (layout_.frames && frames_ < *layout_.frames)
            throw refusal(name_,
                          "the sound file ends after " + std::to_string(frames_) + " of " +
                              std::to_string(*layout_.frames) + " frames",
                          "it is damaged or cut off");
    }

    std::string name_;
    Cursor cursor_;
    SF_INFO info_{};
    std::unique_ptr<SNDFILE, Closer> file_;
    signal::ChannelLayout layout_;
    std::uint64_t frames_ = 0;  // read so far
};

std::string format_name(int format) {
    std::string name;
    for (const int mask : {SF_FORMAT_TYPEMASK, SF_FORMAT_SUBMASK}) {
        SF_FORMAT_INFO info{};
        info.format = format & mask;
        sf_command(nullptr, SFC_GET_FORMAT_INFO, &info, sizeof info);
        if (info.name != nullptr) name += (name.empty() ? "" : ", ") + std::string(info.name);
    }
    return name;
}

using Broadcast = SF_BROADCAST_INFO_VAR(longest_history + 1);

// text of a field that may fill it to its end
std::string text_in(const char* field, std::size_t size) {
    const std::string_view text(field, size);
    return std::string(text.substr(0, text.find('\0')));
}

// libsndfile adds a line of its own behind a history it reads
std::string case_in(const std::string& history) {
    const std::size_t mark = history.find(case_mark);
    return mark == std::string::npos ? "" : history.substr(mark + std::string_view(case_mark).size());
}

std::vector<std::pair<std::string, std::string>> tags(SNDFILE* file) {
    constexpr std::array known{std::pair{SF_STR_TITLE, "title"}, std::pair{SF_STR_ARTIST, "artist"},
                               std::pair{SF_STR_DATE, "date"}, std::pair{SF_STR_COMMENT, "comment"},
                               std::pair{SF_STR_LICENSE, "license"}};
    std::vector<std::pair<std::string, std::string>> found;
    for (const auto& [tag, name] : known)
        if (const char* text = sf_get_string(file, tag); text != nullptr && *text != '\0')
            found.emplace_back(name, text);
    return found;
}

// can libsndfile make anything of it?
bool opens(const SignalInput& input) {
    Cursor cursor{input.bytes, 0};
    SF_INFO info{};
    SF_VIRTUAL_IO door{length_of, seek, read_bytes, write_bytes, tell};
    const std::unique_ptr<SNDFILE, Closer> file(sf_open_virtual(&door, SFM_READ, &info, &cursor));
    return file && info.frames > 0;
}

// libsndfile quietly reads what is there; a recording that was cut off must be told from a whole one
RiffData checked_riff(const SignalInput& input) {
    const std::optional<RiffData> data = find_riff_data(*input.bytes);
    if (!data)
        throw refusal(input.name, "the WAV file has no samples", "there is no data chunk in it", "Is it cut off?");
    if (!data->has_format) throw refusal(input.name, "the WAV file does not say what its samples are", "no fmt chunk");
    if (data->channels == 0) throw refusal(input.name, "the WAV file has 0 channels", "", "Is its header damaged?");
    if (data->rate == 0) throw refusal(input.name, "the WAV file has a rate of 0 Hz", "", "Is its header damaged?");
    if (!data->has_sensible_frames())
        throw refusal(input.name,
                      "the WAV file has samples of " + std::to_string(data->bits) + " bits in frames of " +
                          std::to_string(data->frame_bytes) + " bytes",
                      "they do not fit each other", "Is its header damaged?");
    if (data->available == 0) throw refusal(input.name, "the WAV file holds no samples", "its data chunk is empty");
    if (data->claimed <= data->available || data->has_unknown_length()) return *data;
    throw refusal(input.name, "the WAV file is cut off",
                  "its header speaks of " + std::to_string(data->claimed) + " bytes of samples, " +
                      std::to_string(data->available) + " are there",
                  "To take what is there: sox --ignore-length IN.wav OUT.wav");
}

/// A WAV file as libsndfile takes it, and what to tell of that.
SignalInput readable_wav(const SignalInput& input, std::vector<std::string>& notes) {
    const RiffData data = checked_riff(input);
    const bool is_told = data.claimed > 0 && data.claimed <= data.available;
    if (!is_told)
        notes.emplace_back("the header does not say how long the recording is; all that follows was read as samples");
    const bool is_usual = text_at(*input.bytes, 0, 4) != "BW64" && data.claimed > 0 && !data.has_wide_frames();
    if (is_usual && opens(input)) return input;
    const SignalInput plain{plain_wav(input.bytes, data), input.name, input.sidecar};
    if (!opens(plain)) return input;  // then the library says why
    if (data.has_wide_frames())
        notes.emplace_back("samples of 24 bits stand in 4 bytes each");
    else if (is_told && is_usual)
        notes.emplace_back("the header is damaged; the samples behind it were read");
    return plain;
}

}  // namespace

bool is_audio(std::string_view beginning) {
    constexpr std::array<std::string_view, 11> marks{"RIFF", "RIFX", "RF64", "BW64", "riff", "fLaC",
                                                     "OggS", "FORM", "caff", ".snd", "ID3"};
    const bool is_mp3 =
        beginning.size() > 1 && beginning[0] == '\xFF' && (static_cast<unsigned char>(beginning[1]) & 0xE6U) == 0xE2U;
    return is_mp3 ||
           std::any_of(marks.begin(), marks.end(), [&](std::string_view mark) { return beginning.starts_with(mark); });
}

RawSignal open_audio(const SignalInput& input) {
    const std::string mark = text_at(*input.bytes, 0, 4);
    RawSignal raw;
    SignalInput plain = is_riff_mark(mark) ? readable_wav(input, raw.notes) : input;
    if (!is_riff_mark(mark)) plain.bytes = with_frame_count(plain.bytes);
    auto audio = std::make_unique<Audio>(plain);
    raw.format = format_name(audio->format());
    const int coding = audio->format() & SF_FORMAT_SUBMASK;
    if (coding == SF_FORMAT_FLOAT || coding == SF_FORMAT_DOUBLE) raw.doubt = Doubt::numbers;
    raw.metadata = tags(audio->handle());
    if (auto info = std::make_unique<Broadcast>();
        sf_command(audio->handle(), SFC_GET_BROADCAST_INFO, info.get(), sizeof(Broadcast)) == SF_TRUE) {
        raw.description = text_in(std::begin(info->description), sizeof info->description);
        if (!raw.description.empty()) raw.metadata.emplace_back("description", raw.description);
        const std::size_t length = std::min<std::size_t>(info->coding_history_size, longest_history);
        if (std::string text = case_in(text_in(std::begin(info->coding_history), length)); !text.empty())
            raw.metadata.emplace_back("case", std::move(text));
    }
    for (const auto& [key, text] : raw.metadata)
        if (raw.description.empty() && key == "comment") raw.description = text;
    raw.source = std::move(audio);
    return raw;
}

}  // namespace stridor::recordings
