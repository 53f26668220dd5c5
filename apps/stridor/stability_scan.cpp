#include "stability_scan.hpp"

#include "stridor/base/error.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/parameters/field_name.hpp"

#include <optional>
#include <string>

namespace stridor::app {

namespace {

Error bad_range(const std::string& over) {
    return {ErrorKind::input,
            {"\"" + over + "\" is no range", "expected KEY=FROM:TO or KEY=FROM:TO:POINTS",
             "For example contact.kinetic_friction=0:0.8:161."}};
}

Error bad_points(const std::string& text) {
    return {ErrorKind::input,
            {"\"" + text + "\" is no number of points",
             "a whole number from 2 to " + std::to_string(analysis::most_scan_points), ""}};
}

analysis::ScanRange parse_range(const std::string& over) {
    const std::optional<io::RangeText> text = io::split_range(over);
    if (!text || text->parts.size() < 2 || text->parts.size() > 3) throw bad_range(over);
    const parameters::Field& field = parameters::quantity_named(text->key);
    const io::RangeEnds ends = io::read_range_ends(text->parts[0], text->parts[1], parameters::unit_of(field));
    analysis::ScanRange range;
    range.key = parameters::key_of(field);
    range.from = ends.from;
    range.to = ends.to;
    if (text->parts.size() == 2) return range;
    const std::optional<int> points = io::read_points(text->parts[2], analysis::most_scan_points);
    if (!points) throw bad_points(std::string(text->parts[2]));
    range.points = *points;
    return range;
}

}  // namespace

analysis::StabilityScan scan_stability(const parameters::Case& c, const std::string& over) {
    if (over.empty()) return analysis::scan_stability(c, std::nullopt);
    try {
        return analysis::scan_stability(c, parse_range(over));
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), base::Place{"--over", 0, 0, over});
    }
}

}  // namespace stridor::app
