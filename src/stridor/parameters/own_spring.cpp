#include "stridor/parameters/own_spring.hpp"

#include "stridor/base/text.hpp"
#include "stridor/parameters/tables/curve_rows.hpp"

#include <cstddef>
#include <utility>

namespace stridor::parameters {

namespace {

using base::shortest;

constexpr CurveWords force_words{"table of force", "a deflection, a colon and a force", "1 mm: 2 N", "m", "N"};
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

std::string force_table_text(const ForceTable& table) {
    return table.deflections.empty() ? table.file : rows_text(table.deflections, table.forces);
}

ForceTable parse_force_table(std::string_view text) {
    ForceTable table;
    if (!has_rows(text)) {
        table.file = base::trimmed(text);
        if (table.file.empty()) base::refuse("the table of force is empty", "", "Give rows, or a CSV file.");
        return table;
    }
    CurveRows rows = parse_rows(text, force_words);
    table.deflections = std::move(rows.places);
    table.forces = std::move(rows.values);
    expect_rising(table);
    return table;
}

void expect_rising(const ForceTable& table) {
    const std::vector<double>&e = table.deflections, &F = table.forces;
    expect_some_rows(e.size(), force_words, "cubic = ...");
    for (std::size_t k = 1; k < e.size(); ++k) {
        if (!(e[k] > e[k - 1]))
            refuse_row(k + 1, force_words, "has " + shortest(e[k]) + " m after " + shortest(e[k - 1]) + " m",
                       "force is a function of the deflection: each stands once, and they rise",
                       "Sort the rows; of loading and unloading take one, or their mean.");
        if (!(F[k] >= F[k - 1]))
            refuse_row(k + 1, force_words, "has " + shortest(F[k]) + " N after " + shortest(F[k - 1]) + " N",
                       "a force that falls as its spring is pressed jumps to another place",
                       "Smooth the rows, or leave those out that fall.");
    }
}

}  // namespace stridor::parameters
