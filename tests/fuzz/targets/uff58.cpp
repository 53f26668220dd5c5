#include "stridor/io/uff58.hpp"

#include "fuzz/targets/reading.hpp"

namespace stridor::fuzz {

void uff58(std::string_view bytes) {
    io::is_uff(bytes);
    read_signal(bytes, [](const io::SignalInput& input) { return io::open_uff58(input); });
}

}  // namespace stridor::fuzz
