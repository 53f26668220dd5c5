#pragma once

// ffmpeg's libraries, opened with the first compressed recording. If they were linked, they and the hundred libraries
// they need would make every start of the program three times as long. Private to this folder.

#include "stridor/base/opened_library.hpp"
#include "stridor/recordings/raw_signal.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/cpu.h>
#include <libavutil/macros.h>
#include <libswresample/swresample.h>
}

#include <string>

namespace stridor::recordings {

/// The functions that Stridor uses, of the major versions it was built with.
struct Ffmpeg {
    base::OpenedLibrary avformat{"libavformat.so." AV_STRINGIFY(LIBAVFORMAT_VERSION_MAJOR)};
    base::OpenedLibrary avcodec{"libavcodec.so." AV_STRINGIFY(LIBAVCODEC_VERSION_MAJOR)};
    base::OpenedLibrary avutil{"libavutil.so." AV_STRINGIFY(LIBAVUTIL_VERSION_MAJOR)};
    base::OpenedLibrary swresample{"libswresample.so." AV_STRINGIFY(LIBSWRESAMPLE_VERSION_MAJOR)};
    decltype(&::avformat_alloc_context) avformat_alloc_context = avformat.function("avformat_alloc_context");
    decltype(&::avformat_open_input) avformat_open_input = avformat.function("avformat_open_input");
    decltype(&::avformat_close_input) avformat_close_input = avformat.function("avformat_close_input");
    decltype(&::av_find_input_format) av_find_input_format = avformat.function("av_find_input_format");
    decltype(&::av_read_frame) av_read_frame = avformat.function("av_read_frame");
    decltype(&::avio_alloc_context) avio_alloc_context = avformat.function("avio_alloc_context");
    decltype(&::avio_context_free) avio_context_free = avformat.function("avio_context_free");
    decltype(&::avcodec_find_decoder) avcodec_find_decoder = avcodec.function("avcodec_find_decoder");
    decltype(&::avcodec_get_name) avcodec_get_name = avcodec.function("avcodec_get_name");
    decltype(&::avcodec_alloc_context3) avcodec_alloc_context3 = avcodec.function("avcodec_alloc_context3");
    decltype(&::avcodec_parameters_to_context) avcodec_parameters_to_context =
        avcodec.function("avcodec_parameters_to_context");
    decltype(&::avcodec_open2) avcodec_open2 = avcodec.function("avcodec_open2");
    decltype(&::avcodec_free_context) avcodec_free_context = avcodec.function("avcodec_free_context");
    decltype(&::avcodec_send_packet) avcodec_send_packet = avcodec.function("avcodec_send_packet");
    decltype(&::avcodec_receive_frame) avcodec_receive_frame = avcodec.function("avcodec_receive_frame");
    decltype(&::av_packet_alloc) av_packet_alloc = avcodec.function("av_packet_alloc");
    decltype(&::av_packet_free) av_packet_free = avcodec.function("av_packet_free");
    decltype(&::av_packet_unref) av_packet_unref = avcodec.function("av_packet_unref");
    decltype(&::av_frame_alloc) av_frame_alloc = avutil.function("av_frame_alloc");
    decltype(&::av_frame_free) av_frame_free = avutil.function("av_frame_free");
    decltype(&::av_malloc) av_malloc = avutil.function("av_malloc");
    decltype(&::av_free) av_free = avutil.function("av_free");
    decltype(&::av_max_alloc) av_max_alloc = avutil.function("av_max_alloc");
    decltype(&::av_dict_get) av_dict_get = avutil.function("av_dict_get");
    decltype(&::av_dict_set) av_dict_set = avutil.function("av_dict_set");
    decltype(&::av_dict_free) av_dict_free = avutil.function("av_dict_free");
    decltype(&::av_strerror) av_strerror = avutil.function("av_strerror");
    decltype(&::av_log_set_level) av_log_set_level = avutil.function("av_log_set_level");
    decltype(&::av_force_cpu_flags) av_force_cpu_flags = avutil.function("av_force_cpu_flags");
    decltype(&::swr_alloc_set_opts2) swr_alloc_set_opts2 = swresample.function("swr_alloc_set_opts2");
    decltype(&::swr_init) swr_init = swresample.function("swr_init");
    decltype(&::swr_convert) swr_convert = swresample.function("swr_convert");
    decltype(&::swr_free) swr_free = swresample.function("swr_free");
};

/// Returns the libraries, opened once for the process. They print nothing, allocate at most 256 MiB at a time, and
/// compute alike on every processor. Null if this machine lacks them.
const Ffmpeg* ffmpeg_library();

/// Opens the first stream of sound; `kind` is the file's kind in messages, `demuxer` ffmpeg's name of its reader.
RawSignal open_with_ffmpeg(const Ffmpeg& ffmpeg, const SignalInput& input, const std::string& kind,
                           const std::string& demuxer);

}  // namespace stridor::recordings
