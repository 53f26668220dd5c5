#include "library.hpp"
#include "stridor/base/error.hpp"

#include <sndfile.h>

namespace stridor::app {

void probe_sound(const std::filesystem::path& file, noise_library::Entry& entry) {
    SF_INFO info{};
    SNDFILE* sound = sf_open(file.c_str(), SFM_READ, &info);
    if (sound == nullptr)
        throw Error(ErrorKind::input, {file.string() + " is no sound that can be read", sf_strerror(nullptr),
                                       "WAV, FLAC and Ogg files can be added."});
    sf_close(sound);
    if (info.samplerate <= 0 || info.channels <= 0 || info.frames <= 0)
        throw Error(ErrorKind::input, {file.string() + " holds no sound", "it has no samples", ""});
    entry.rate = info.samplerate;
    entry.channels = info.channels;
    entry.duration = static_cast<double>(info.frames) / info.samplerate;
}

}  // namespace stridor::app
