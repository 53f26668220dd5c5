#include "stridor/io/calibration.hpp"

#include "fuzz/targets/targets.hpp"
#include "stridor/base/error.hpp"

#include <cmath>

namespace stridor::fuzz {

void calibration(std::string_view bytes) {
    const auto check = [](const io::FullScale& scale) {
        require(scale.value > 0.0 && std::isfinite(scale.value) && !scale.unit.empty());
    };
    if (const auto found = io::calibration_in(bytes)) {
        check(*found);
        // what is written of it is read as the same
        if (found->unit != signal::full_scale) require(io::calibration_in(io::calibration_text(*found)) == found);
    }
    try {
        check(io::parse_full_scale(bytes));
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::input);
    }
}

}  // namespace stridor::fuzz
