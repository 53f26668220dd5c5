#include "stridor/parameters/tables/force_table.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/tables/curve_rows.hpp"

#include <cstddef>
#include <utility>

namespace stridor::parameters {

namespace {

constexpr CurveWords force_words{"table of force", "a deflection, a colon and a force", "1 mm: 2 N", "m", "N"};

}  // namespace

std::string force_table_text(const ForceTable& table) {
    return table.deflections.empty() ? table.file : rows_text(table.deflections, table.forces);
}

ForceTable parse_force_table(std::string_view text) {
    CurveRows rows = parse_rows(text, force_words);
    ForceTable table{std::move(rows.file), std::move(rows.places), std::move(rows.values)};
    if (table.file.empty()) expect_rising(table);
    return table;
}

void expect_rising(const ForceTable& table) {
    const std::vector<double>&e = table.deflections, &F = table.forces;
    expect_some_rows(e.size(), force_words, "cubic = ...");
    for (std::size_t k = 1; k < e.size(); ++k) {
        if (!(e[k] > e[k - 1]))
            refuse_row(k + 1, force_words,
                       "has " + base::shortest(e[k]) + " m after " + base::shortest(e[k - 1]) + " m",
                       "force is a function of the deflection: each stands once, and they rise",
                       "Sort the rows; of loading and unloading take one, or their mean.");
        if (!(F[k] >= F[k - 1]))
            refuse_row(k + 1, force_words,
                       "has " + base::shortest(F[k]) + " N after " + base::shortest(F[k - 1]) + " N",
                       "a force that falls as its spring is pressed jumps to another place",
                       "Smooth the rows, or leave those out that fall.");
    }
}

}  // namespace stridor::parameters
