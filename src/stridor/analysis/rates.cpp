#include "stridor/analysis/rates.hpp"

#include "stridor/base/check.hpp"

#include <cmath>
#include <limits>
#include <numeric>

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

Rates rates(const std::array<double, model::contact_states>& time) {
    const double total = time[0] + time[1] + time[2];
    if (!(total > 0.0)) {
        constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
        return {nothing, nothing, nothing};
    }
    return {time[model::index_of(model::ContactState::slip)] / total,
            time[model::index_of(model::ContactState::stick)] / total,
            time[model::index_of(model::ContactState::separation)] / total};
}

Rates share_errors(const record::ContactTally& tally) {
    if (tally.ending.outlook.future == record::Future::repeats) return {};
    if (tally.stretches.empty()) {
        constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
        return {unknown, unknown, unknown};
    }
    return {share_error(tally, model::ContactState::slip), share_error(tally, model::ContactState::stick),
            share_error(tally, model::ContactState::separation)};
}

Interface interface_of(const record::Tally& tally, std::size_t interface) {
    STRIDOR_EXPECT(interface < tally.interfaces.size());
    const record::InterfaceTally& counted = tally.interfaces[interface];
    Interface whole{counted.contacts, std::vector<CarriedLoad>(counted.contacts.size()), counted.state_time};
    const double time = std::accumulate(whole.rates.begin(), whole.rates.end(), 0.0);
    for (double& rate : whole.rates)
        rate /= time;  // NaN where nothing was judged
    double sum = 0.0;
    for (std::size_t k = 0; k < whole.contacts.size(); ++k) {
        const record::Load& load = tally.contacts[whole.contacts[k]].load;
        whole.loads[k] = {load.normal_impulse / time, load.normal_impulse, load.friction_loss / time};
        sum += load.normal_impulse;
    }
    const double equal = 1.0 / static_cast<double>(whole.loads.size());
    for (CarriedLoad& load : whole.loads) {
        load.share = sum > 0.0 ? load.share / sum : equal;
        load.is_loaded = load.share >= least_load * equal;
    }
    return whole;
}

double free_together(const record::InterfaceTally& tally, const Interface& whole, std::span<const std::size_t> some) {
    double load = 0.0, free = 0.0, together = 0.0;
    for (const std::size_t i : some) {
        const double weight = whole.loads[i].share;
        load += weight;
        free += weight * tally.free_together[i * whole.contacts.size() + i];
        for (const std::size_t j : some)
            together += weight * whole.loads[j].share * tally.free_together[i * whole.contacts.size() + j];
    }
    return free > 0.0 ? together / (load * free) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace stridor::analysis
