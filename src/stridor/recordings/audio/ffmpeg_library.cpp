#include "stridor/recordings/audio/ffmpeg_library.hpp"

#include <cstddef>

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

}  // namespace

const Ffmpeg* ffmpeg_library() {
    static const SetUpFfmpeg opened;
    return opened.is_whole ? &opened : nullptr;
}

}  // namespace stridor::recordings
