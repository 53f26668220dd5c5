#include "fuzz/targets/targets.hpp"

#include <cstddef>
#include <cstdint>

// libFuzzer's door to one target
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    stridor::fuzz::STRIDOR_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
    return 0;
}
