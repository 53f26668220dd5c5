#include "stridor/parameters/tables/curve_rows.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"

namespace stridor::parameters {

std::string rows_text(const std::vector<double>& places, const std::vector<double>& values) {
    std::string text;
    for (std::size_t k = 0; k < places.size(); ++k)
        text += (k == 0 ? "" : ", ") + base::shortest(places[k]) + ": " + base::shortest(values[k]);
    return text;
}

void refuse_row(std::size_t row, const CurveWords& words, const std::string& what, const std::string& why,
                const std::string& remedy) {
    base::refuse("row " + std::to_string(row) + " of the " + std::string(words.table) + " " + what, why, remedy);
}

CurveRows parse_rows(std::string_view text, const CurveWords& words) {
    CurveRows rows;
    if (text.find(':') == std::string_view::npos) {
        rows.file = base::trimmed(text);
        if (rows.file.empty())
            base::refuse("the " + std::string(words.table) + " is empty", "", "Give rows, or a CSV file.");
        return rows;
    }
    for (std::size_t row = 1; !text.empty(); ++row) {
        const std::size_t end = text.find(',');
        const std::string_view one = base::trimmed(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        const std::size_t colon = one.find(':');
        if (colon == std::string_view::npos || one.find(':', colon + 1) != std::string_view::npos)
            refuse_row(row, words, "is \"" + std::string(one) + "\"", "a row is " + std::string(words.row),
                       "Write \"" + std::string(words.example) + "\".");
        if (row > most_curve_rows) refuse_row(row, words, "is one too many", "10,000 are kept", "Thin them out.");
        rows.places.push_back(base::parse_quantity(one.substr(0, colon), words.place_unit));
        rows.values.push_back(base::parse_quantity(one.substr(colon + 1), words.value_unit));
    }
    return rows;
}

void expect_some_rows(std::size_t rows, const CurveWords& words, std::string_view instead) {
    const std::string has = "the " + std::string(words.table) + " has " + std::to_string(rows) + " row";
    if (rows < 2)
        base::refuse(has + (rows == 1 ? "" : "s"), "a curve needs two at least",
                     "Add one, or use " + std::string(instead) + ".");
    if (rows > most_curve_rows)
        base::refuse(has + "s", "10,000 are kept at most", "Thin them out: it is smooth in between.");
}

}  // namespace stridor::parameters
