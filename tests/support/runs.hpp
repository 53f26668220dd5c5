#pragma once

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace stridor::support {

/// Which of the endless numbered random cases a fuzz test looks at.
struct Runs {
    std::uint64_t first = 0;
    std::uint64_t count = 0;  // [1]
};

/// So many runs, or what STRIDOR_FUZZ_RUNS and STRIDOR_FUZZ_FIRST in the environment say.
inline Runs runs(std::uint64_t usual) {
    const auto asked = [](const char* name, std::uint64_t otherwise) {
        const char* text = std::getenv(name);
        if (text != nullptr) std::from_chars(text, text + std::strlen(text), otherwise);
        return otherwise;
    };
    return {asked("STRIDOR_FUZZ_FIRST", 0), asked("STRIDOR_FUZZ_RUNS", usual)};
}

}  // namespace stridor::support
