#include "stridor/recordings/audio/riff.hpp"

#include "fuzz/targets/targets.hpp"

#include <cstdlib>
#include <string>

namespace stridor::fuzz {

void riff(std::string_view bytes) {
    const auto data = recordings::find_riff_data(*recordings::bytes_of(std::string(bytes)));
    if (data) require(data->offset + data->available == bytes.size());
}

}  // namespace stridor::fuzz
