#pragma once

#include "stridor/model/laws/friction.hpp"

#include <functional>
#include <optional>

/// The slip that a step of time leaves where friction changes with the slip velocity.
///
/// Its velocity w follows from T/N, and T/N from w. With mu = |T/N| and the speed s(mu) of slip that it leaves, falling
/// by `reach` per mu at most, psi(mu) = mu - law(s(mu)) is 0. Where reach times the slope by which friction falls is 1
/// or more, several mu may be lawful. The least of them is the slip that goes on: it is reached from no friction, as an
/// impulse grows from nothing, without a jump. psi rises by at most 1 + reach times the law's steepest rise, so
///
///     mu <- mu - psi(mu)/(1 + reach rise)                from mu = 0
///
/// never passes it. What is left is bracketed, and found by Newton's method or by halving.
namespace stridor::integration {

/// Says whether Newton's method alone finds the slip: with slopes of psi between 3/4 and 5/4 it is the only one, and an
/// error falls to two thirds or less in each turn. `reach` [m/s] is how far w changes per T/N.
inline bool is_gentle(const model::SlopeRange& slopes, double reach) {
    constexpr double gentle = 0.25;  // [1]
    return -slopes.least * reach <= gentle && slopes.most * reach <= gentle;
}

/// Returns T/N of the fastest lawful slip one way. `velocity_at` gives the slip velocity [m/s] that a T/N leaves. A
/// slip that would turn round has the ratio of one that begins. Nothing where no ratio is lawful: friction presses the
/// contact.
std::optional<double> ratio_of_fastest_slip(const model::FrictionLaw& law, model::Slip way, double reach,
                                            const std::function<double(double)>& velocity_at);

}  // namespace stridor::integration
