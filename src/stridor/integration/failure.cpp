#include "stridor/integration/failure.hpp"

#include "stridor/base/text.hpp"
#include "stridor/integration/cost.hpp"
#include "stridor/parameters/rules/engines.hpp"
#include "stridor/parameters/system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace stridor::integration {

Error beyond_step_limit(const parameters::Case& c) {
    const double limit = cost(c).step_limit;
    const bool is_moreau = parameters::engine_of(c) == parameters::Engine::moreau;
    return {ErrorKind::input,
            {fmt::format("run.step = {} s is beyond the {} {:.4g} s", base::shortest(c.run.step),
                         is_moreau ? "limit" : "stability limit", limit),
             fmt::format("at twice the step, with which it is compared, {}",
                         is_moreau ? "more than half a period of the fastest mode would pass"
                                   : "the highest open mode would grow without bound"),
             fmt::format("Use at most {:.1g} s; 1e-06 s or less for rates you quote.", 0.1 * limit)}};
}

namespace {

constexpr std::size_t most_named = 12;  // contacts in one sentence

// what each contact did where the motion ended: "; lip1 sticks, lip2 is separated"
std::string last_set(const parameters::Case& c, const Motion& motion) {
    constexpr std::array<std::string_view, model::contact_states> does{"slips", "sticks", "is separated"};
    const bool has_names = parameters::has_named_contacts(c);
    std::string text;
    for (std::size_t k = 0; k < std::min(most_named, motion.last_set.size()); ++k)
        text += fmt::format("{} {} {}", k == 0 ? ";" : ",", has_names ? parameters::contact_name(c, k) : "the contact",
                            does[model::index_of(motion.last_set[k])]);
    if (motion.last_set.size() > most_named)
        text += fmt::format(", and {} contacts more", motion.last_set.size() - most_named);
    return text;
}

// "lip1 and lip2"
std::string pressed_names(const parameters::Case& c, const Motion& motion) {
    if (!parameters::has_named_contacts(c) || motion.pressed.empty() || motion.pressed.size() > most_named)
        return "the contact";
    std::string text;
    for (const std::size_t k : motion.pressed)
        text += (text.empty() ? "" : " and ") + parameters::contact_name(c, k);
    return text;
}

}  // namespace

std::optional<Error> failure(const parameters::Case& c, const Motion& motion) {
    const std::string at = fmt::format("{:.6g} s of {:g} s", motion.outcome.time, c.run.duration);
    switch (motion.outcome.reason) {
        case Reason::completed:
        case Reason::settled:
            break;
        case Reason::diverged:
            return Error(ErrorKind::numerical,
                         {"the motion left double precision at " + at, "its forces or velocities have no end",
                          "Check the units of the case."});
        case Reason::step_limit:
            return beyond_step_limit(c);
        case Reason::chattering:
            if (parameters::has_friction_state(c.contact().friction))
                return Error(ErrorKind::numerical,
                             {"the motion comes to no end at " + at,
                              "where a contact creeps, its friction state changes too fast for it",
                              "Choose another law of friction, or a faster motion."});
            return Error(ErrorKind::numerical, {"events pile up without end at " + at + last_set(c, motion),
                                                "double precision cannot tell them apart, so the motion stops there",
                                                "Change a parameter a little, or try run.engine = \"beta_2\"."});
        case Reason::unbalanced:
            return Error(ErrorKind::numerical, {fmt::format("the energy balance is off by {:.1g} of the turnover",
                                                            motion.energy.relative_residual()),
                                                "the motion hangs on differences that double precision does not hold",
                                                "Check the units of the case, or use a smaller run.step with beta_2."});
        case Reason::painleve:
            return Error(
                ErrorKind::numerical,
                {"no forces obey all laws of contact at " + at + last_set(c, motion),
                 "friction presses " + pressed_names(c, motion) + " together without end: a Painleve configuration",
                 "Use less friction, or a structure that gives way more along its normals."});
        case Reason::no_forces:
            return Error(ErrorKind::numerical, {"no contact forces were found at " + at + last_set(c, motion),
                                                "no set of contact states that was tried obeys all laws of contact",
                                                "Change a parameter a little, or try another run.engine."});
        case Reason::cancelled:
            return Error(ErrorKind::interrupted,
                         {"stopped at " + at, "a run that is stopped keeps nothing", "Run the same command again."});
    }
    return std::nullopt;
}

}  // namespace stridor::integration
