#include "stridor/io/chart/scan_range.hpp"

#include "stridor/base/error.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/parameters/case_key.hpp"

#include <optional>

namespace stridor::io {

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

}  // namespace

analysis::ScanRange read_scan_range(const std::string& over) {
    const std::optional<RangeText> text = split_range(over);
    if (!text || text->parts.size() < 2 || text->parts.size() > 3) throw bad_range(over);
    analysis::ScanRange range;
    range.key = parameters::quantity_key_called(text->key);
    const RangeEnds ends = read_range_ends(text->parts[0], text->parts[1], parameters::unit_of(range.key));
    range.from = ends.from;
    range.to = ends.to;
    if (text->parts.size() == 2) return range;
    const std::optional<int> points = read_points(text->parts[2], analysis::most_scan_points);
    if (!points) throw bad_points(std::string(text->parts[2]));
    range.points = *points;
    return range;
}

}  // namespace stridor::io
