#include "stridor/analysis/stability_scan.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/model/rubbing_system.hpp"
#include "stridor/parameters/field_name.hpp"

#include <utility>

namespace stridor::analysis {

namespace {

void check(const parameters::Case& c, const parameters::Field& field, const ScanRange& range) {
    if (!(range.from < range.to) || range.points < 2 || range.points > most_scan_points)
        throw Error(ErrorKind::input,
                    {range.key + " cannot be followed from " + base::shortest(range.from) + " to " +
                         base::shortest(range.to) + " at " + std::to_string(range.points) + " points",
                     "the ends must rise, and 2 to " + std::to_string(most_scan_points) + " points do",
                     range.from > range.to ? "Swap the ends?" : ""});
    if (!field.belongs(c))
        throw Error(ErrorKind::input,
                    {range.key + " changes nothing", "this case, with its kind of drive and start, does not use it",
                     "`stridor check FILE` lists what it uses."});
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
        field = &parameters::quantity_named(range->key);
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
