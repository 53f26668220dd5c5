#pragma once

#include "stridor/base/error.hpp"
#include "support/effort.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

namespace stridor::support {

/// What becomes of a file in which single bits are wrong.
struct FlipCounts {
    long same = 0;     // what was read is what was written
    long refused = 0;  // an `Error` that says so
};

/// Which bits are flipped: every one with STRIDOR_FULL in the environment, else each `release`-th or `checked`-th. Odd
/// steps meet all places within a byte.
inline std::size_t flip_step(std::size_t release, std::size_t checked) {
    return std::getenv("STRIDOR_FULL") != nullptr ? 1 : effort(release, checked);
}

inline std::string whole_file(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline void put_file(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

/// Flips bits of a file, one at a time, and reads it: each time `read` gives the very same text as before, or throws
/// an `Error` of this kind. The file is as before at the end.
inline FlipCounts flip_bits(const std::filesystem::path& file, std::size_t step, base::ErrorKind kind,
                            const std::function<std::string()>& read) {
    const std::string good = read();
    const std::string bytes = whole_file(file);
    FlipCounts counts;
    for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += step) {
        std::string damaged = bytes;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
        put_file(file, damaged);
        try {
            const bool is_same = read() == good;
            EXPECT_TRUE(is_same) << "bit " << bit << " of " << file;
            ++counts.same;
            if (!is_same) break;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), kind) << "bit " << bit << " of " << file << ": " << error.what();
            ++counts.refused;
        }
    }
    put_file(file, bytes);
    EXPECT_EQ(read(), good);
    testing::Test::RecordProperty("same", static_cast<int>(counts.same));
    testing::Test::RecordProperty("refused", static_cast<int>(counts.refused));
    return counts;
}

}  // namespace stridor::support
