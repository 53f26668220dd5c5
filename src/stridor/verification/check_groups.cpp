#include "stridor/verification/check_groups.hpp"

#include "stridor/verification/belt.hpp"
#include "stridor/verification/constant_drive.hpp"
#include "stridor/verification/damped_slip.hpp"
#include "stridor/verification/den_hartog.hpp"
#include "stridor/verification/sliding.hpp"
#include "stridor/verification/table_1.hpp"

#include <array>

namespace stridor::verification {

std::span<const CheckGroup> check_groups() {
    static constexpr std::array groups{
        CheckGroup{"natural frequencies", "Table 1 parameters, undamped eigenvalues, closed form",
                   natural_frequency_checks},
        CheckGroup{"stability of steady sliding", "4 by 4 eigenvalue problem solved independently", stability_checks},
        CheckGroup{"observed order of beta_2", "damped oscillator in pure slip, closed form", order_checks},
        CheckGroup{"mass on a belt", "stick time 2 lambda / w0, slip time 2 (pi - atan lambda) / w0", belt_checks},
        CheckGroup{"dry-friction oscillator", "Den Hartog 1931, continuous sliding", den_hartog_checks},
        CheckGroup{"Table 1, sinusoidal drive", "stored digits of the exact engine; beta_2 within its own error",
                   table_1_checks},
        CheckGroup{"constant drive", "exact piecewise linear solution", constant_drive_checks},
    };
    return groups;
}

}  // namespace stridor::verification
