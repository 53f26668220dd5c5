#include "stridor/recordings/audio/compressed_audio.hpp"

#include "stridor/recordings/refusal.hpp"

#if STRIDOR_HAS_FFMPEG
#    include "stridor/recordings/audio/ffmpeg_source.hpp"
#endif

#include <algorithm>
#include <array>
#include <optional>

namespace stridor::recordings {

namespace {

/// A kind of file.
struct Kind {
    std::string_view name;     // for people
    std::string_view demuxer;  // ffmpeg's name
    std::size_t offset;        // [bytes] of the mark
    std::string_view mark;
};

constexpr std::array kinds{Kind{"MPEG-4", "mov", 4, "ftyp"},    Kind{"QuickTime", "mov", 4, "moov"},
                           Kind{"QuickTime", "mov", 4, "wide"}, Kind{"QuickTime", "mov", 4, "mdat"},
                           Kind{"AMR", "amr", 0, "#!AMR"},      Kind{"Matroska", "matroska", 0, "\x1A\x45\xDF\xA3"}};

// the mark of AAC in a stream is twelve set bits and two clear ones
bool is_adts(std::string_view beginning) {
    return beginning.size() > 1 && beginning[0] == '\xFF' &&
           (static_cast<unsigned char>(beginning[1]) & 0xF6U) == 0xF0U;
}

std::optional<Kind> kind_of(std::string_view beginning) {
    if (is_adts(beginning)) return Kind{"AAC", "aac", 0, ""};
    for (const Kind& kind : kinds)
        if (beginning.size() > kind.offset && beginning.substr(kind.offset).starts_with(kind.mark)) return kind;
    return std::nullopt;
}

}  // namespace

bool is_compressed_audio(std::string_view beginning) {
    return kind_of(beginning).has_value();
}

RawSignal open_compressed_audio(const SignalInput& input) {
    const std::optional<Kind> kind = kind_of(text_at(*input.bytes, 0, 16));
    if (!kind) throw refusal(input.name, "this is no compressed sound that is known");
    const std::string what = "this is a compressed sound (" + std::string(kind->name) + ")";
#if STRIDOR_HAS_FFMPEG
    if (const Ffmpeg* ffmpeg = ffmpeg_library())
        return open_with_ffmpeg(*ffmpeg, input, std::string(kind->name), std::string(kind->demuxer));
    throw refusal(input.name, what, "ffmpeg's libraries, which read it, are not on this machine",
                  "Install them (Debian: apt-get install ffmpeg), or convert it elsewhere: ffmpeg -i IN OUT.wav");
#else
    throw refusal(input.name, what, "this program was built without ffmpeg's libraries, which read it",
                  "Convert it first: ffmpeg -i IN OUT.wav");
#endif
}

}  // namespace stridor::recordings
