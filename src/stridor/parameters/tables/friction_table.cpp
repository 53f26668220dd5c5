#include "stridor/parameters/tables/friction_table.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/tables/curve_rows.hpp"

#include <cstddef>
#include <utility>

namespace stridor::parameters {

namespace {

constexpr CurveWords friction_words{"table of friction", "a speed, a colon and a coefficient", "10 mm/s: 0.6", "m/s",
                                    "1"};

}  // namespace

std::string friction_table_text(const FrictionTable& table) {
    return table.speeds.empty() ? table.file : rows_text(table.speeds, table.coefficients);
}

FrictionTable parse_friction_table(std::string_view text) {
    CurveRows rows = parse_rows(text, friction_words);
    FrictionTable table{std::move(rows.file), std::move(rows.places), std::move(rows.values)};
    if (table.file.empty()) expect_function(table);
    return table;
}

void expect_function(const FrictionTable& table) {
    expect_some_rows(table.speeds.size(), friction_words, "\"coulomb\"");
    for (std::size_t k = 0; k < table.speeds.size(); ++k) {
        if (table.speeds[k] < 0.0)
            refuse_row(k + 1, friction_words, "has a speed of " + base::shortest(table.speeds[k]) + " m/s",
                       "speeds of slip have no sign: the law is the same both ways", "Give its size.");
        if (k > 0 && !(table.speeds[k] > table.speeds[k - 1]))
            refuse_row(
                k + 1, friction_words,
                "has " + base::shortest(table.speeds[k]) + " m/s after " + base::shortest(table.speeds[k - 1]) + " m/s",
                "friction is a function of the speed: each speed stands once, and they rise",
                "Sort the rows; of several at one speed give their mean.");
        if (table.coefficients[k] < 0.0)
            refuse_row(k + 1, friction_words, "has a coefficient of " + base::shortest(table.coefficients[k]),
                       "friction acts against the slip", "Give its size.");
    }
}

}  // namespace stridor::parameters
