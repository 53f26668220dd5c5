#include "stridor/analysis/rates.hpp"

#include <limits>

namespace stridor::analysis {

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

}  // namespace stridor::analysis
