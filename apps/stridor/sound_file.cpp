#include "sound_file.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

namespace stridor::app {

namespace {

constexpr std::size_t block_frames = 1U << 14U;
constexpr double largest = 8388607.0;          // of 24 bits
constexpr std::size_t description_size = 256;  // of a bext chunk (EBU Tech 3285)
constexpr std::size_t bext_size = 602;

void put(std::string& bytes, std::uint64_t number, int count) {
    for (int k = 0; k < count; ++k)
        bytes.push_back(static_cast<char>(static_cast<unsigned char>(number >> (8 * k) & 0xffU)));
}

std::string header(const signal::Layout& layout, const SoundFileInfo& info) {
    const std::uint64_t data = *layout.frames * 3;
    const auto rate = static_cast<std::uint64_t>(std::llround(layout.rate));
    std::string text = "full scale = " + base::shortest(info.full_scale) + " " + layout.channels.front().unit + "; " +
                       info.description;
    text.resize(std::min(text.size(), description_size - 1));
    std::string bext = text;
    bext.resize(bext_size, '\0');
    std::string bytes = "RIFF";
    put(bytes, 4 + 8 + bext_size + 8 + 16 + 8 + data + data % 2, 4);
    bytes += "WAVEbext";
    put(bytes, bext_size, 4);
    bytes += bext + "fmt ";
    put(bytes, 16, 4);
    put(bytes, 1, 2);  // whole numbers
    put(bytes, 1, 2);  // channels
    put(bytes, rate, 4);
    put(bytes, 3 * rate, 4);
    put(bytes, 3, 2);
    put(bytes, 24, 2);
    bytes += "data";
    put(bytes, data, 4);
    return bytes;
}

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

class Writer {
public:
    explicit Writer(const std::string& path) : path_(path), file_(std::fopen(path.c_str(), "wb")) {
        if (!file_) fail();
    }
    void write(std::string_view bytes) {
        if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) fail();
    }
    void close() {
        if (std::fflush(file_.get()) != 0) fail();
        file_.reset();
    }

private:
    [[noreturn]] void fail() {
        const std::string reason = std::strerror(errno);
        file_.reset();
        std::remove(path_.c_str());
        throw Error(ErrorKind::io, {"cannot write " + path_, reason, ""});
    }
    std::string path_;
    std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace

void write_sound(const std::string& path, signal::Source& sound, const SoundFileInfo& info) {
    if (*sound.layout().frames > 1'400'000'000)
        throw Error(ErrorKind::input, {"the sound is too long for a WAV file", "it may hold 4 GB", "Ask for less."});
    const std::string temporary = path + ".part";
    Writer writer(temporary);
    writer.write(header(sound.layout(), info));
    std::vector<double> block(block_frames);
    std::string bytes;
    while (const std::size_t count = sound.read(block)) {
        bytes.clear();
        for (std::size_t k = 0; k < count; ++k) {
            const double number = std::nearbyint(std::clamp(block[k] / info.full_scale, -1.0, 1.0) * largest);
            put(bytes, static_cast<std::uint64_t>(static_cast<std::int64_t>(number)), 3);
        }
        writer.write(bytes);
    }
    if (*sound.layout().frames % 2 != 0) writer.write(std::string_view("\0", 1));
    writer.close();
    if (std::rename(temporary.c_str(), path.c_str()) != 0) {
        const std::string reason = std::strerror(errno);
        std::remove(temporary.c_str());
        throw Error(ErrorKind::io, {"cannot write " + path, reason, ""});
    }
}

}  // namespace stridor::app
