#include "stridor/model/laws/rest.hpp"

#include "stridor/base/elementary.hpp"

#include <algorithm>
#include <numbers>

namespace stridor::model {

double grown(const RestGrowth& rest, double rested) {
    constexpr double largest_ratio = 1e300;  // [1] a quotient beyond double precision
    const double ratio = rested > 0.0 ? std::min(rested / rest.time, largest_ratio) : 0.0;
    switch (rest.kind) {
        case parameters::RestKind::none:
            break;
        case parameters::RestKind::logarithmic:
            return rest.growth * (std::numbers::ln2 * base::logarithm_2(1.0 + ratio));
        case parameters::RestKind::kato:
            return rest.growth * (1.0 - base::exponential(-base::power(ratio, rest.exponent)));
    }
    return 0.0;
}

RestGrowth rest_growth(const parameters::Contact& contact) {
    if (!grows_with_rest(contact)) return {};
    return {contact.rest, contact.rest_growth, contact.rest_time, contact.rest_exponent, contact.rested};
}

}  // namespace stridor::model
