#include "stridor/console/results/following_text.hpp"

#include "stridor/console/results/text_table.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/sweep/starts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace stridor::console {

namespace {

using sweep::FollowedRun;
using sweep::FollowedWay;

// behind a number; of one without a unit nothing
std::string unit_text(const sweep::Following& following) {
    const std::string unit(parameters::unit_of(following.over.key));
    return unit == "1" ? "" : " " + unit;
}

std::string_view word_of(const FollowedRun& run, std::size_t direction) {
    return sweep::word(run.cells[direction]);
}

// runs one after the other with one verdict
void add_stretches(TextTable& table, const sweep::Following& following, std::size_t direction) {
    const std::vector<FollowedRun>& runs = following.runs;
    for (std::size_t k = 0; k < runs.size();) {
        std::size_t last = k;
        while (last + 1 < runs.size() && runs[last + 1].way == runs[k].way &&
               word_of(runs[last + 1], direction) == word_of(runs[k], direction))
            ++last;
        add_row(table, parameters::direction_names[static_cast<std::size_t>(following.directions[direction])],
                sweep::way_names[static_cast<std::size_t>(runs[k].way)], fmt::format("{:g}", runs[k].value),
                fmt::format("{:g}", runs[last].value), word_of(runs[k], direction));
        k = last + 1;
    }
}

std::string hysteresis_text(const sweep::Following& following, std::size_t direction) {
    const std::vector<double> values = sweep::hysteresis(following, direction);
    const std::string_view way = parameters::direction_names[static_cast<std::size_t>(following.directions[direction])];
    if (values.empty()) return fmt::format("{}: up and down have the same verdicts\n", way);
    return fmt::format("{}: up and down differ at {} of {} values, from {:g} to {:g}{}\n", way, values.size(),
                       following.over.points, values.front(), values.back(), unit_text(following));
}

}  // namespace

std::string following_text(const sweep::Following& following) {
    TextTable table{{left("direction"), left("way"), right("from"), right("to"), left("verdict")}};
    for (std::size_t d = 0; d < following.directions.size(); ++d)
        add_stretches(table, following, d);
    std::string text =
        fmt::format("{} from {:g} to {:g}{} and back, {} values\n", following.over.key, following.over.from,
                    following.over.to, unit_text(following), following.over.points) +
        "\n" + text_of(table) + "\n";
    for (std::size_t d = 0; d < following.directions.size(); ++d)
        text += hysteresis_text(following, d);
    return text;
}

}  // namespace stridor::console
