#include "stridor/analysis/stability_scan.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/model/rubbing_system.hpp"
#include "stridor/parameters/field.hpp"

#include <utility>

namespace stridor::analysis {

namespace {

const parameters::Field& quantity_named(const std::string& key) {
    const parameters::Field* field = parameters::find_field(key);
    const bool is_quantity = field != nullptr && std::holds_alternative<parameters::Quantity>(field->kind);
    if (is_quantity) return *field;
    const std::string near = parameters::nearest_key(key);
    throw Error(ErrorKind::input,
                {"\"" + key + "\" is no quantity of a case", "only quantities can be followed",
                 near.empty() ? "`stridor init squeal` shows all keys." : "Did you mean \"" + near + "\"?"});
}

void check(const parameters::Case& c, const parameters::Field& field, const ScanRange& range) {
    if (!(range.from < range.to) || range.points < 2 || range.points > most_scan_points)
        throw Error(ErrorKind::input,
                    {range.key + " cannot be followed from " + base::shortest(range.from) + " to " +
                         base::shortest(range.to) + " at " + std::to_string(range.points) + " points",
                     "the ends must rise, and 2 to " + std::to_string(most_scan_points) + " points do", ""});
    // both ends must be values the parameter can take
    parameters::Case copy = c;
    parameters::set_quantity(copy, field, range.from);
    parameters::set_quantity(copy, field, range.to);
}

}  // namespace

StabilityScan scan_stability(const parameters::Case& c, const std::optional<ScanRange>& range) {
    StabilityScan scan;
    scan.base = c;
    const parameters::Field* field = nullptr;
    if (range) {
        field = &quantity_named(range->key);
        check(c, *field, *range);
        scan.key = parameters::key_of(*field);
        scan.unit = parameters::unit_of(*field);
    }
    for (const parameters::Direction direction : {parameters::Direction::going, parameters::Direction::coming}) {
        DirectionScan along{direction, sliding_stability(model::rubbing_system(c), direction), {}};
        const auto at = [&](double value) {
            parameters::Case changed = c;
            parameters::set_quantity(changed, *field, value);
            return sliding_stability(model::rubbing_system(changed), direction);
        };
        if (range) along.path = stability_path(at, range->from, range->to, range->points);
        scan.directions.push_back(std::move(along));
    }
    return scan;
}

}  // namespace stridor::analysis
