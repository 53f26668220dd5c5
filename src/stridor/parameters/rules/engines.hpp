#pragma once

#include "stridor/base/error.hpp"
#include "stridor/parameters/case.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What each engine can solve, in one table: checks of cases, the engines themselves and their documentation ask it.
namespace stridor::parameters {

/// The methods behind `run.engine` and `run.formulation`. A case goes to `taylor` where its engine is exact and more
/// than one joint, or a structure of one's own, moves, or where friction changes with the slip velocity or with rest.
enum class Method { exact, taylor, moreau, massless, beta_2 };
inline constexpr std::array<std::string_view, 5> method_names{"exact", "Taylor", "moreau", "massless", "beta_2"};

/// What a motion may ask of a method beside one joint of two or three degrees of freedom on a surface that moves, with
/// plastic impacts and friction that does not change while the contact slips one way.
enum class Demand {
    several_contacts,
    own_structure,        // a structure of one's own
    any_size,             // other than two or three degrees of freedom
    two_tangents,         // a contact that slips in two directions
    other_cone,           // beside such a contact other friction than Coulomb's
    imposed_force,        // a force shakes the structure
    other_impacts,        // than plastic ones
    other_friction,       // a coefficient that changes with the slip velocity: a law that is not state-wise
    unexpanded_friction,  // such a law without a power series along the motion
    growing_friction,     // static friction that grows with rest
    friction_state,       // such a law with a state of the contact
    other_springs,        // than linear ones
    massless_rows,        // rows without mass
    joint,                // the mass of a joint stands at its contact
};
inline constexpr std::array<std::string_view, 14> demand_names{
    "several contacts",
    "a structure of one's own",
    "any number of degrees of freedom",
    "a contact that slips in two directions",
    "friction other than Coulomb's beside it",
    "a force that shakes the structure",
    "impacts other than plastic ones",
    "friction that changes with the slip velocity",
    "friction without a power series",
    "static friction that grows with rest",
    "friction with a state of the contact",
    "springs other than linear ones",
    "rows without mass",
    "the joint on a plate",
};

/// Returns the engine that computes a case: the one that it names. Where it leaves the choice (`Engine::automatic`),
/// the exact one, or moreau where that cannot solve it.
Engine engine_of(const Case& c);

/// Returns why the exact engine cannot solve a case that leaves the choice of its engine, so that moreau does. Nothing
/// where it can, or where the case names an engine.
std::optional<base::Problem> why_not_exact(const Case& c);

/// Says whether the exact engine goes from event to event by Taylor series.
bool is_solved_by_series(const Case& c);

/// Says whether only the contacts of a case move without inertia.
bool is_without_inertia(const Case& c);

/// Returns the methods that a case is solved by: two where both formulations are run.
std::vector<Method> methods_of(const Case& c);

/// Something that a case, or a joint of it, asks for, and where: "row x has no mass"; empty: nowhere in particular.
struct Asked {
    Demand demand = Demand::joint;
    std::string where{};
};
std::vector<Asked> demands_of(CaseView at);

/// Returns why a method cannot do what is asked: what, as "the exact engine knows one contact", why, and what to do
/// instead. Nothing where it can. `name` stands for that of the method.
std::optional<base::Problem> refusal(Method method, const Asked& asked, std::string_view name = {});

/// The field a user would change, and those it depends on besides.
struct DemandKeys {
    std::string_view key;
    std::vector<std::string_view> others{};
};
DemandKeys keys_of(Demand demand);

}  // namespace stridor::parameters
