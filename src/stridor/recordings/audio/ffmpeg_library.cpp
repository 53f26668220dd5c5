#include "stridor/recordings/audio/ffmpeg_library.hpp"

#include <dlfcn.h>

#include <memory>
#include <string>

namespace stridor::recordings {

namespace {

constexpr std::size_t largest_piece = std::size_t{1} << 28U;  // [bytes] of memory

/// One of the libraries, open as long as the process lives.
class LoadedLibrary {
public:
    LoadedLibrary(const std::string& name, int version)
        : handle_(::dlopen(("lib" + name + ".so." + std::to_string(version)).c_str(), RTLD_LAZY | RTLD_LOCAL)) {}

    template <typename Function>
    bool find(Function& function, const char* name) const {
        if (handle_ != nullptr) function = reinterpret_cast<Function>(::dlsym(handle_, name));
        return function != nullptr;
    }

private:
    void* handle_;
};

bool find_formats(Ffmpeg& ffmpeg, const LoadedLibrary& library) {
    return library.find(ffmpeg.avformat_alloc_context, "avformat_alloc_context") &&
           library.find(ffmpeg.avformat_open_input, "avformat_open_input") &&
           library.find(ffmpeg.avformat_close_input, "avformat_close_input") &&
           library.find(ffmpeg.av_find_input_format, "av_find_input_format") &&
           library.find(ffmpeg.av_read_frame, "av_read_frame") &&
           library.find(ffmpeg.avio_alloc_context, "avio_alloc_context") &&
           library.find(ffmpeg.avio_context_free, "avio_context_free");
}

bool find_codecs(Ffmpeg& ffmpeg, const LoadedLibrary& library) {
    return library.find(ffmpeg.avcodec_find_decoder, "avcodec_find_decoder") &&
           library.find(ffmpeg.avcodec_get_name, "avcodec_get_name") &&
           library.find(ffmpeg.avcodec_alloc_context3, "avcodec_alloc_context3") &&
           library.find(ffmpeg.avcodec_parameters_to_context, "avcodec_parameters_to_context") &&
           library.find(ffmpeg.avcodec_open2, "avcodec_open2") &&
           library.find(ffmpeg.avcodec_free_context, "avcodec_free_context") &&
           library.find(ffmpeg.avcodec_send_packet, "avcodec_send_packet") &&
           library.find(ffmpeg.avcodec_receive_frame, "avcodec_receive_frame") &&
           library.find(ffmpeg.av_packet_alloc, "av_packet_alloc") &&
           library.find(ffmpeg.av_packet_free, "av_packet_free") &&
           library.find(ffmpeg.av_packet_unref, "av_packet_unref");
}

bool find_tools(Ffmpeg& ffmpeg, const LoadedLibrary& library) {
    return library.find(ffmpeg.av_frame_alloc, "av_frame_alloc") &&
           library.find(ffmpeg.av_frame_free, "av_frame_free") && library.find(ffmpeg.av_malloc, "av_malloc") &&
           library.find(ffmpeg.av_free, "av_free") && library.find(ffmpeg.av_max_alloc, "av_max_alloc") &&
           library.find(ffmpeg.av_dict_get, "av_dict_get") && library.find(ffmpeg.av_dict_set, "av_dict_set") &&
           library.find(ffmpeg.av_dict_free, "av_dict_free") && library.find(ffmpeg.av_strerror, "av_strerror") &&
           library.find(ffmpeg.av_log_set_level, "av_log_set_level") &&
           library.find(ffmpeg.av_force_cpu_flags, "av_force_cpu_flags");
}

bool find_conversion(Ffmpeg& ffmpeg, const LoadedLibrary& library) {
    return library.find(ffmpeg.swr_alloc_set_opts2, "swr_alloc_set_opts2") &&
           library.find(ffmpeg.swr_init, "swr_init") && library.find(ffmpeg.swr_convert, "swr_convert") &&
           library.find(ffmpeg.swr_free, "swr_free");
}

std::unique_ptr<const Ffmpeg> opened() {
    auto ffmpeg = std::make_unique<Ffmpeg>();
    const bool is_whole = find_formats(*ffmpeg, LoadedLibrary("avformat", LIBAVFORMAT_VERSION_MAJOR)) &&
                          find_codecs(*ffmpeg, LoadedLibrary("avcodec", LIBAVCODEC_VERSION_MAJOR)) &&
                          find_tools(*ffmpeg, LoadedLibrary("avutil", LIBAVUTIL_VERSION_MAJOR)) &&
                          find_conversion(*ffmpeg, LoadedLibrary("swresample", LIBSWRESAMPLE_VERSION_MAJOR));
    if (!is_whole) return nullptr;
    ffmpeg->av_log_set_level(AV_LOG_QUIET);
    ffmpeg->av_max_alloc(largest_piece);
    // assembly for one processor or another rounds otherwise
    ffmpeg->av_force_cpu_flags(0);
    return ffmpeg;
}

}  // namespace

const Ffmpeg* ffmpeg_library() {
    static const std::unique_ptr<const Ffmpeg> library = opened();
    return library.get();
}

}  // namespace stridor::recordings
