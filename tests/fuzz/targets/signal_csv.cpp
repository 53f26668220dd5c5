#include "stridor/recordings/table/signal_csv.hpp"

#include "fuzz/targets/reading.hpp"

namespace stridor::fuzz {

void signal_csv(std::string_view bytes) {
    read_signal(bytes, [](const recordings::SignalInput& input) { return recordings::open_signal_csv(input); });
}

}  // namespace stridor::fuzz
