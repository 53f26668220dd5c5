#include "stridor/analysis/sliding_stability.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/model/contact_state.hpp"
#include "stridor/model/equilibrium.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace stridor::analysis {

namespace {

bool slower(const Eigenmode& a, const Eigenmode& b) {
    return a.frequency != b.frequency ? a.frequency < b.frequency : a.growth < b.growth;
}

}  // namespace

SlidingStability classify_modes(const std::vector<std::complex<double>>& eigenvalues, double normal_force) {
    SlidingStability result;
    result.normal_force = normal_force;
    for (const std::complex<double>& value : eigenvalues)
        if (value.imag() >= 0.0) result.modes.push_back({value.real(), value.imag() / base::two_pi});
    std::sort(result.modes.begin(), result.modes.end(), slower);
    const auto fastest = std::max_element(result.modes.begin(), result.modes.end(),
                                          [](const Eigenmode& a, const Eigenmode& b) { return a.growth < b.growth; });
    if (fastest == result.modes.end()) return result;
    result.growth = fastest->growth;
    result.frequency = fastest->frequency;
    if (!(normal_force > 0.0))
        result.kind = StabilityKind::locked;
    else if (fastest->growth > model::growth_rounding(eigenvalues))
        result.kind = fastest->frequency > 0.0 ? StabilityKind::flutter : StabilityKind::divergence;
    return result;
}

SteadySliding steady_sliding(const model::Structure& structure, parameters::Direction direction) {
    model::expect_one_tangent(structure, "the stability of steady sliding");
    std::vector<double> ratios =
        model::sliding_ratios(structure, direction == parameters::Direction::going ? 1.0 : -1.0);
    model::ClosedContacts found = model::closed_contacts(structure, ratios);
    std::vector<model::ContactState> states(structure.contacts.size(), model::ContactState::separation);
    for (const std::size_t number : found.closed)
        states[number] = model::ContactState::slip;
    model::SlidingMotion motion = model::sliding_motion(structure, states, ratios);
    if (!has_inertia(motion))
        base::refuse("the stability of steady sliding needs inertia",
                     "a motion that the closed contacts allow moves no mass", "Give each row that can move a mass.");
    return {std::move(found), std::move(ratios), std::move(motion)};
}

SlidingStability sliding_stability(const model::Structure& structure, parameters::Direction direction) {
    const auto [found, ratios, motion] = steady_sliding(structure, direction);
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t number : found.closed)
        least = std::min(least, found.equilibrium.normal_forces(static_cast<Eigen::Index>(number)));
    SlidingStability stability = classify_modes(eigenvalues(motion), least);
    for (std::size_t number = 0; number < structure.contacts.size(); ++number)
        if (std::find(found.closed.begin(), found.closed.end(), number) == found.closed.end())
            stability.open.push_back(number);
    return stability;
}

}  // namespace stridor::analysis
