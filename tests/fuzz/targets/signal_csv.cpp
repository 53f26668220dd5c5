#include "stridor/io/signal_csv.hpp"

#include "fuzz/targets/reading.hpp"

namespace stridor::fuzz {

void signal_csv(std::string_view bytes) {
    read_signal(bytes, [](const io::SignalInput& input) { return io::open_signal_csv(input); });
}

}  // namespace stridor::fuzz
