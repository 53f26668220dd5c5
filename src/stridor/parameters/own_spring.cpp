#include "stridor/parameters/own_spring.hpp"

#include "stridor/base/text.hpp"

namespace stridor::parameters {

namespace {

using base::shortest;

constexpr double least_exponent = 1.0, most_exponent = 3.0;  // [1] of a power

bool has_force_table(const OwnSpring& spring) {
    return !spring.table.deflections.empty() || !spring.table.file.empty();
}

}  // namespace

SpringKind kind_of(const OwnSpring& spring) {
    if (has_force_table(spring)) return SpringKind::table;
    if (spring.force != 0.0) return SpringKind::power;
    return spring.cubic != 0.0 ? SpringKind::cubic : SpringKind::linear;
}

std::optional<base::Problem> problem_of(const OwnSpring& spring) {
    const std::string name = "spring \"" + spring.name + "\"";
    const int laws = (spring.cubic != 0.0 ? 1 : 0) + (spring.force != 0.0 ? 1 : 0) + (has_force_table(spring) ? 1 : 0);
    if (laws > 1)
        return base::Problem{name + " has more than one law", "its force is cubic, a power or a table",
                             "Make a spring of each."};
    if (spring.force != 0.0 && !(spring.deflection > 0.0))
        return base::Problem{name + " has a force without a deflection",
                             "its force is that force at that deflection, and a power of it elsewhere",
                             "Add deflection = \"1 mm\"."};
    if (spring.force == 0.0 && (spring.deflection != 0.0 || spring.gap != 0.0))
        return base::Problem{name + " has a " + (spring.gap != 0.0 ? "gap" : "deflection") + " without a force",
                             "it belongs to a power of the deflection", "Add force = \"10 N\", or take it out."};
    if (!(spring.exponent >= least_exponent && spring.exponent <= most_exponent))
        return base::Problem{name + " has an exponent of " + shortest(spring.exponent), "it must be from 1 to 3", ""};
    if (spring.preload_share > 0.0 && kind_of(spring) == SpringKind::linear)
        return base::Problem{name + " is linear and has a share of the preload",
                             "what a linear spring bears at rest changes no motion", "Take the share out."};
    return std::nullopt;
}

}  // namespace stridor::parameters
