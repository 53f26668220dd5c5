#include "stridor/recordings/uff58/uff58.hpp"

#include "fuzz/targets/reading.hpp"

namespace stridor::fuzz {

void uff58(std::string_view bytes) {
    recordings::is_uff(bytes);
    read_signal(bytes, [](const recordings::SignalInput& input) { return recordings::open_uff58(input); });
}

}  // namespace stridor::fuzz
