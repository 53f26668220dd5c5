#include "stridor/parameters/tables/friction_table.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"

#include <cstddef>

namespace stridor::parameters {

namespace {

[[noreturn]] void refuse_row(std::size_t row, const std::string& what, const std::string& why,
                             const std::string& remedy) {
    base::refuse("row " + std::to_string(row) + " of the table of friction " + what, why, remedy);
}

}  // namespace

std::string friction_table_text(const FrictionTable& table) {
    if (table.speeds.empty()) return table.file;
    std::string text;
    for (std::size_t k = 0; k < table.speeds.size(); ++k)
        text += (k == 0 ? "" : ", ") + base::shortest(table.speeds[k]) + ": " + base::shortest(table.coefficients[k]);
    return text;
}

FrictionTable parse_friction_table(std::string_view text) {
    FrictionTable table;
    if (text.find(':') == std::string_view::npos) {
        table.file = base::trimmed(text);
        if (table.file.empty()) base::refuse("the table of friction is empty", "", "Give rows, or a CSV file.");
        return table;
    }
    for (std::size_t row = 1; !text.empty(); ++row) {
        const std::size_t end = text.find(',');
        const std::string_view one = base::trimmed(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        const std::size_t colon = one.find(':');
        if (colon == std::string_view::npos || one.find(':', colon + 1) != std::string_view::npos)
            refuse_row(row, "is \"" + std::string(one) + "\"", "a row is a speed, a colon and a coefficient",
                       "Write \"10 mm/s: 0.6\".");
        if (row > most_friction_rows) refuse_row(row, "is one too many", "10,000 are kept", "Thin them out.");
        table.speeds.push_back(base::parse_quantity(one.substr(0, colon), "m/s"));
        table.coefficients.push_back(base::parse_quantity(one.substr(colon + 1), "1"));
    }
    expect_function(table);
    return table;
}

void expect_function(const FrictionTable& table) {
    if (table.speeds.size() < 2)
        base::refuse("the table of friction has " + std::to_string(table.speeds.size()) + " row" +
                         (table.speeds.size() == 1 ? "" : "s"),
                     "a curve needs two at least", "Add one, or use \"coulomb\".");
    if (table.speeds.size() > most_friction_rows)
        base::refuse("the table of friction has " + std::to_string(table.speeds.size()) + " rows",
                     "10,000 are kept at most", "Thin them out: it is smooth in between.");
    for (std::size_t k = 0; k < table.speeds.size(); ++k) {
        if (table.speeds[k] < 0.0)
            refuse_row(k + 1, "has a speed of " + base::shortest(table.speeds[k]) + " m/s",
                       "speeds of slip have no sign: the law is the same both ways", "Give its size.");
        if (k > 0 && !(table.speeds[k] > table.speeds[k - 1]))
            refuse_row(
                k + 1,
                "has " + base::shortest(table.speeds[k]) + " m/s after " + base::shortest(table.speeds[k - 1]) + " m/s",
                "friction is a function of the speed: each speed stands once, and they rise",
                "Sort the rows; of several at one speed give their mean.");
        if (table.coefficients[k] < 0.0)
            refuse_row(k + 1, "has a coefficient of " + base::shortest(table.coefficients[k]),
                       "friction acts against the slip", "Give its size.");
    }
}

}  // namespace stridor::parameters
