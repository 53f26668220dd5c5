#include "stridor/recordings/audio/compressed_audio.hpp"

#include "fuzz/targets/reading.hpp"

namespace stridor::fuzz {

void compressed_audio(std::string_view bytes) {
    // a byte of a packed format stands for up to so many frames
    constexpr std::uint64_t most_per_byte = 8192;
    read_signal(
        bytes, [](const recordings::SignalInput& input) { return recordings::open_compressed_audio(input); },
        most_per_byte);
}

}  // namespace stridor::fuzz
