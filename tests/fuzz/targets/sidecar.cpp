#include "stridor/recordings/sidecar.hpp"

#include "fuzz/targets/targets.hpp"
#include "stridor/base/error.hpp"

#include <cmath>

namespace stridor::fuzz {

void sidecar(std::string_view bytes) {
    try {
        const recordings::Sidecar sidecar = recordings::parse_sidecar(bytes, "input");
        // what was read can be written, and reads back as the same
        const recordings::Sidecar back = recordings::parse_sidecar(recordings::sidecar_json(sidecar), "written");
        require(back.rate == sidecar.rate && back.channels.size() == sidecar.channels.size());
        for (std::size_t k = 0; k < sidecar.channels.size(); ++k) {
            require(back.channels[k].name == sidecar.channels[k].name);
            require(back.channels[k].full_scale == sidecar.channels[k].full_scale);
        }
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::input && error.place().has_value());
    }
}

}  // namespace stridor::fuzz
