#include "stridor/analysis/share_errors.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

namespace stridor::analysis {

namespace {

using record::StretchTimes;

// groups of one stretch: the more stretches there are, the fewer of each are needed
std::size_t groups_of_each(std::size_t stretches) {
    if (stretches == 1) return record::stretch_parts;
    if (stretches <= 3) return record::stretch_parts / 2;
    return stretches == 4 ? 2 : 1;
}

// share of a group's time spent in a state
double group_share(const StretchTimes& stretch, std::size_t group, std::size_t groups, std::size_t state) {
    const std::size_t parts = record::stretch_parts / groups;
    double time = 0.0, whole = 0.0;
    for (std::size_t part = group * parts; part < (group + 1) * parts; ++part) {
        time += stretch[part][state];
        whole += stretch[part][0] + stretch[part][1] + stretch[part][2];
    }
    return time / whole;
}

double share_error(const record::ContactTally& tally, model::ContactState state) {
    const std::size_t stretches = tally.stretches.size();
    const std::size_t groups = groups_of_each(stretches);
    // what is held against its mean: the groups of the only stretch, or those at one place of all
    const std::size_t places = stretches == 1 ? 1 : groups;
    const std::size_t each = stretches == 1 ? groups : stretches;
    double squares = 0.0;
    for (std::size_t place = 0; place < places; ++place) {
        const auto share = [&](std::size_t k) {
            return stretches == 1 ? group_share(tally.stretches[0], k, groups, model::index_of(state))
                                  : group_share(tally.stretches[k], place, groups, model::index_of(state));
        };
        double mean = 0.0;
        for (std::size_t k = 0; k < each; ++k)
            mean += share(k) / static_cast<double>(each);
        for (std::size_t k = 0; k < each; ++k)
            squares += (share(k) - mean) * (share(k) - mean);
    }
    const double variance = squares / static_cast<double>(places * (each - 1));
    return std::sqrt(variance / (static_cast<double>(groups) * static_cast<double>(tally.judged_stretches)));
}

}  // namespace

Rates share_errors(const record::ContactTally& tally) {
    if (tally.ending.outlook.future == record::Future::repeats) return {};
    if (tally.stretches.empty()) {
        constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
        return {unknown, unknown, unknown};
    }
    return {share_error(tally, model::ContactState::slip), share_error(tally, model::ContactState::stick),
            share_error(tally, model::ContactState::separation)};
}

}  // namespace stridor::analysis
