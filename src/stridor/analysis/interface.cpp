#include "stridor/analysis/interface.hpp"

#include "stridor/base/check.hpp"

#include <limits>
#include <numeric>

namespace stridor::analysis {

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
