#pragma once

#include "stridor/base/hash.hpp"
#include "support/counter_random.hpp"
#include "support/process.hpp"
#include "unit/noise_library/library_folder.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What the tests of `stridor library` share: recordings, a folder, and a library in it.
namespace stridor::support {

inline std::string little_endian(std::uint32_t value, int bytes) {
    std::string text;
    for (int k = 0; k < bytes; ++k)
        text += static_cast<char>(value >> static_cast<unsigned>(8 * k) & 0xffU);
    return text;
}

// 16 bit, one channel, 8000 Hz; another seed, other samples
inline std::string wav(std::uint64_t seed, std::size_t frames = 800) {
    CounterRandom random(seed);
    std::string samples;
    for (std::size_t k = 0; k < frames; ++k)
        samples += little_endian(static_cast<std::uint32_t>(random.next() & 0xffffU), 2);
    const auto size = static_cast<std::uint32_t>(samples.size());
    return "RIFF" + little_endian(36 + size, 4) + "WAVEfmt " + little_endian(16, 4) + little_endian(1, 2) +
           little_endian(1, 2) + little_endian(8000, 4) + little_endian(16000, 4) + little_endian(2, 2) +
           little_endian(16, 2) + "data" + little_endian(size, 4) + samples;
}

inline bool has_its_bytes(const noise_library::Library& library, const noise_library::Entry& entry) {
    return base::sha256_text(read_text(library.audio_file(entry))) == entry.audio;
}

class LibraryProgram : public testing::Test {
protected:
    Finished stridor(const std::vector<std::string>& arguments) const {
        return run(Launch{arguments, folder_.path(), {}, std::nullopt, {{"XDG_DATA_HOME", folder_.path() / "data"}}});
    }
    void expect_done(const std::vector<std::string>& arguments) const {
        const Finished finished = stridor(arguments);
        EXPECT_EQ(finished.exit_code, 0) << finished.err;
    }
    void expect_refused(const std::vector<std::string>& arguments, int exit_code,
                        const std::vector<std::string>& words) const {
        const Finished finished = stridor(arguments);
        EXPECT_EQ(finished.exit_code, exit_code) << finished.err;
        EXPECT_EQ(finished.out, "");
        for (const std::string& word : words)
            EXPECT_NE(finished.err.find(word), std::string::npos) << "\"" << word << "\" is not in:\n" << finished.err;
    }
    std::string broken_promise(const char* name = "library.sqlite") const {
        noise_library::Library library(folder_ / name, {noise_library::Access::fill, std::chrono::seconds(10)});
        return noise_library::broken_promise(library, has_its_bytes);
    }

    ScratchFolder folder_;
};

inline const std::vector<std::string> in_file{"--library", "library.sqlite"};

inline std::vector<std::string> with_file(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), in_file.begin(), in_file.end());
    return arguments;
}

}  // namespace stridor::support
