#include "stridor/sound/exceedance.hpp"

#include "stridor/base/elementary.hpp"

#include <algorithm>
#include <cstddef>

namespace stridor::sound {

namespace {

constexpr double least_counted = 1e-3;
constexpr double most_counted = 1e4;  // also for what is beyond all numbers
constexpr double counts_per_octave = 0.6931471805599453 / 0.001;

}  // namespace

void Exceedance::count(double value) {
    greatest_ = std::max(greatest_, value);
    ++values_;
    const double bounded = value < most_counted ? std::max(value, least_counted) : most_counted;
    const double place = counts_per_octave * base::logarithm_2(bounded / least_counted);
    ++counts_[std::min(counts_.size() - 1, static_cast<std::size_t>(place))];
}

double Exceedance::exceeded(double share) const {
    const double wanted = share * static_cast<double>(values_);
    std::uint64_t above = 0;
    for (std::size_t k = counts_.size(); k-- > 1;) {
        above += counts_[k];
        if (static_cast<double>(above) > wanted)
            return least_counted * base::power_of_2((static_cast<double>(k) + 0.5) / counts_per_octave);
    }
    return 0.0;
}

}  // namespace stridor::sound
