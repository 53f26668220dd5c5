#include "stridor/recordings/calibration.hpp"

#include "fuzz/targets/targets.hpp"
#include "stridor/base/error.hpp"

#include <cmath>

namespace stridor::fuzz {

void calibration(std::string_view bytes) {
    const auto check = [](const recordings::FullScale& scale) {
        require(scale.value > 0.0 && std::isfinite(scale.value) && !scale.unit.empty());
    };
    if (const auto found = recordings::calibration_in(bytes)) {
        check(*found);
        // what is written of it is read as the same
        if (found->unit != signal::full_scale)
            require(recordings::calibration_in(recordings::calibration_text(*found)) == found);
    }
    try {
        check(recordings::parse_full_scale(bytes));
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::input);
    }
}

}  // namespace stridor::fuzz
