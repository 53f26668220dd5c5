#include "stridor/parameters/rules/engines.hpp"

#include "stridor/parameters/system.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace stridor::parameters {

namespace {

// what some methods cannot do; whatever stands in no row, they can
struct Lack {
    std::initializer_list<Demand> demands;
    std::initializer_list<Method> methods;
    std::string_view what;  // behind the name of the engine
    std::string_view why;
    std::string_view remedy;
};

const Lack lacks[] = {
    {{Demand::several_contacts},
     {Method::exact, Method::beta_2},
     "knows one contact",
     "several joints are solved by exact or moreau",
     "Set run.engine = \"exact\"."},
    {{Demand::own_structure},
     {Method::beta_2},
     "knows the paper's joint",
     "a structure of one's own is solved by exact or moreau",
     "Set run.engine = \"exact\"."},
    {{Demand::any_size},
     {Method::exact},
     "knows two or three degrees of freedom",
     "more are solved by Taylor series, or by steps",
     "Use the Taylor engine."},
    {{Demand::two_tangents},
     {Method::exact, Method::taylor, Method::beta_2},
     "knows one direction of slip",
     "its events, or the trial of its steps, are of one",
     "Set run.engine = \"moreau\"."},
    {{Demand::other_cone},
     {Method::exact, Method::taylor, Method::moreau, Method::massless, Method::beta_2},
     "knows a circular cone alone for friction in a plane",
     "it has the same coefficients every way",
     "Set friction = \"coulomb\"."},
    {{Demand::imposed_force},
     {Method::exact, Method::taylor, Method::beta_2},
     "knows no drive by force",
     "its events, or its steps, follow a surface that moves",
     "Set run.engine = \"moreau\"."},
    {{Demand::other_impacts},
     {Method::taylor},
     "knows plastic impacts only beyond the paper's joint",
     "other laws say nothing of impacts that meet at the same instant",
     "Set impact = \"plastic\"."},
    {{Demand::other_impacts},
     {Method::moreau, Method::massless, Method::beta_2},
     "knows plastic impacts only",
     "its impacts are what its steps make of them",
     "Set impact = \"plastic\", or run.engine = \"exact\" for a joint alone."},
    {{Demand::other_friction, Demand::unexpanded_friction, Demand::friction_state},
     {Method::exact},
     "knows no friction that changes with the slip velocity",
     "what it solves between events is linear",
     "Use the Taylor engine."},
    {{Demand::other_friction, Demand::unexpanded_friction, Demand::friction_state},
     {Method::massless},
     "knows no friction that changes with the slip velocity without inertia at the contacts",
     "there forces answer places, not velocities",
     "Set run.formulation = \"standard\"."},
    {{Demand::unexpanded_friction},
     {Method::taylor},
     "has no power series of this law of friction",
     "where a slip begins it is not analytic, or it never sticks",
     "Set run.engine = \"moreau\", or another law; a stribeck_exponent that is a whole number has one."},
    {{Demand::growing_friction},
     {Method::exact},
     "knows no static friction that grows with rest",
     "its formulas have one limit for all of a stick",
     "Use the Taylor engine."},
    {{Demand::friction_state},
     {Method::moreau, Method::beta_2},
     "knows no friction with a state of the contact",
     "its steps know contacts that stick, and these creep",
     "Set run.engine = \"exact\"."},
    {{Demand::other_springs},
     {Method::exact, Method::moreau, Method::massless, Method::beta_2},
     "knows linear springs only",
     "what it solves between events, or in a step, is linear",
     "Set run.engine = \"exact\"."},
    {{Demand::massless_rows},
     {Method::exact, Method::taylor, Method::moreau, Method::beta_2},
     "needs mass in each row",
     "events and impacts need inertia",
     "Set run.engine = \"moreau\" and run.formulation = \"massless\"."},
    {{Demand::joint},
     {Method::massless},
     "cannot leave out inertia: the contact of a joint has inertia",
     "its mass stands there: without it another system moves",
     "Use \"standard\"; a structure of your own may do without."},
};

// has the contact's law a power series along any motion (model/laws/friction_jet)? A power of the slip velocity
// that is no whole number has none where a slip begins
bool has_series(const Contact& contact) {
    const bool has_power = contact.friction == FrictionKind::stribeck ||
                           contact.friction == FrictionKind::stribeck_rational ||
                           contact.friction == FrictionKind::lugre;
    if (has_power) return contact.stribeck_exponent == std::floor(contact.stribeck_exponent);
    return !is_regularised(contact.friction);
}

// beyond the paper's joint, where it stiffens, and where friction changes with the slip velocity or with rest
bool needs_series(const Case& c) {
    return !has_one_joint(c) || !is_state_wise(c.contact().friction) || grows_with_rest(c.contact()) ||
           !names_of_springs(c).empty();
}

}  // namespace

std::optional<base::Problem> refusal(Method method, const Asked& asked, std::string_view name) {
    if (name.empty()) name = method_names[static_cast<std::size_t>(method)];
    for (const Lack& lack : lacks)
        if (std::count(lack.demands.begin(), lack.demands.end(), asked.demand) > 0 &&
            std::count(lack.methods.begin(), lack.methods.end(), method) > 0)
            return base::Problem{"the " + std::string(name) + " engine " + std::string(lack.what) +
                                     (asked.where.empty() ? "" : ": " + asked.where),
                                 std::string(lack.why), std::string(lack.remedy)};
    return std::nullopt;
}

std::optional<base::Problem> why_not_exact(const Case& c) {
    if (c.run.engine != Engine::automatic) return std::nullopt;
    const Method method = needs_series(c) ? Method::taylor : Method::exact;
    for (std::size_t joint = 0; joint < c.joints.size(); ++joint)
        for (const Asked& asked : demands_of({c, joint}))
            if (std::optional<base::Problem> problem = refusal(method, asked, "exact")) return problem;
    return std::nullopt;
}

Engine engine_of(const Case& c) {
    if (c.run.engine != Engine::automatic) return c.run.engine;
    return why_not_exact(c) ? Engine::moreau : Engine::exact;
}

bool is_solved_by_series(const Case& c) {
    return engine_of(c) == Engine::exact && needs_series(c);
}

bool is_without_inertia(const Case& c) {
    return engine_of(c) == Engine::moreau && c.run.formulation == Formulation::massless;
}

std::vector<Method> methods_of(const Case& c) {
    switch (engine_of(c)) {
        case Engine::exact:
            return {is_solved_by_series(c) ? Method::taylor : Method::exact};
        case Engine::beta_2:
            return {Method::beta_2};
        case Engine::moreau:
        case Engine::automatic:
            break;
    }
    if (c.run.formulation == Formulation::standard) return {Method::moreau};
    if (c.run.formulation == Formulation::massless) return {Method::massless};
    return {Method::moreau, Method::massless};
}

std::vector<Asked> demands_of(CaseView at) {
    const Case& c = at.c;
    const Contact& contact = at.own().contact;
    std::vector<Asked> asked;
    if (!c.own_structure) asked.push_back({Demand::joint});
    if (c.own_structure) {
        asked.push_back({Demand::own_structure});
        if (const std::optional<std::size_t> row = massless_row(*c.own_structure))
            asked.push_back({Demand::massless_rows, "row " + c.own_structure->row[*row] + " has no mass"});
        const std::vector<OwnContact>& contacts = c.own_structure->contacts;
        const auto plane = std::find_if(contacts.begin(), contacts.end(),
                                        [](const OwnContact& each) { return !each.second_tangent.empty(); });
        if (plane != contacts.end()) {
            const std::string where = "contact \"" + plane->name + "\" slips in two directions";
            asked.push_back({Demand::two_tangents, where});
            if (contact.friction != FrictionKind::coulomb) asked.push_back({Demand::other_cone, where});
        }
        if (is_by_force(c.drive) && !c.own_structure->force.empty()) asked.push_back({Demand::imposed_force});
    }
    if (const std::vector<std::string> springs = names_of_springs(c); !springs.empty())
        asked.push_back({Demand::other_springs, "spring \"" + springs.front() + "\" is not"});
    if (has_several_joints(c)) asked.push_back({Demand::several_contacts});
    if (contact.impact != ImpactKind::plastic) asked.push_back({Demand::other_impacts});
    if (!is_state_wise(contact.friction)) asked.push_back({Demand::other_friction});
    if (!has_series(contact)) asked.push_back({Demand::unexpanded_friction});
    if (grows_with_rest(contact)) asked.push_back({Demand::growing_friction});
    if (has_friction_state(contact.friction)) asked.push_back({Demand::friction_state});
    return asked;
}

DemandKeys keys_of(Demand demand) {
    switch (demand) {
        case Demand::other_cone:
            return {"contact.friction"};
        case Demand::other_impacts:
            return {"contact.impact", {"run.engine"}};
        case Demand::other_friction:
        case Demand::unexpanded_friction:
        case Demand::friction_state:
            return {"contact.friction", {"run.engine", "run.formulation"}};
        case Demand::growing_friction:
            return {"contact.rest", {"run.engine"}};
        case Demand::imposed_force:
            return {"run.engine", {"drive.kind"}};
        case Demand::other_springs:
            return {"run.engine", {"joint.stiffening"}};
        case Demand::massless_rows:
            return {"run.engine", {"run.formulation"}};
        case Demand::joint:
            return {"run.formulation", {"run.engine"}};
        case Demand::several_contacts:
        case Demand::own_structure:
        case Demand::any_size:
        case Demand::two_tangents:
            break;
    }
    return {"run.engine"};
}

}  // namespace stridor::parameters
