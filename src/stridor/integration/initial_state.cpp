#include "stridor/integration/initial_state.hpp"

#include "stridor/base/error.hpp"
#include "stridor/model/equilibrium.hpp"

namespace stridor::integration {

InitialState initial_state(const model::Structure& structure, const Start& start, double surface_velocity) {
    using parameters::Initial;
    const model::ContactPoint& contact = model::only_contact(structure, "a start of one contact");
    if (start.kind == Initial::sliding && surface_velocity == 0.0)
        throw Error(ErrorKind::input, {"initial = \"sliding\" has no direction", "the drive stands still at the start",
                                       "Start with initial = \"rest\"."});
    const std::vector<double> ratios =
        start.kind == Initial::sliding ? model::sliding_ratios(structure, surface_velocity) : std::vector<double>{0.0};
    const model::Equilibrium balance = model::equilibrium(structure, ratios);
    if (!(balance.normal_forces(0) > 0.0))
        throw Error(ErrorKind::numerical, {"steady sliding has no equilibrium in this direction",
                                           "its normal force would be negative: the contact digs in (sprag-slip)",
                                           "Start with initial = \"rest\"."});
    const double speed = start.kind == Initial::rest    ? 0.0
                         : start.kind == Initial::stuck ? surface_velocity
                                                        : start.perturbation;
    return {balance.displacement, contact.tangent / contact.tangent.squaredNorm() * speed};
}

}  // namespace stridor::integration
