#include "stability_scan.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/model/rubbing_system.hpp"
#include "stridor/parameters/field.hpp"

#include <charconv>
#include <vector>

namespace stridor::app {

namespace {

constexpr int default_points = 41;
constexpr int most_points = 100000;

struct Range {
    const parameters::Field* field = nullptr;
    double from = 0.0;
    double to = 0.0;
    int points = default_points;
};

Error bad_range(const std::string& over) {
    return {ErrorKind::input,
            {"--over \"" + over + "\" cannot be read", "expected KEY=FROM:TO or KEY=FROM:TO:POINTS",
             "For example contact.kinetic_friction=0:0.8:161."}};
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (const char letter : text)
        if (letter == separator)
            parts.emplace_back();
        else
            parts.back() += letter;
    return parts;
}

const parameters::Field& quantity_named(const std::string& key) {
    const parameters::Field* field = parameters::find_field(key);
    const bool is_quantity = field != nullptr && std::holds_alternative<parameters::Quantity>(field->kind);
    if (is_quantity) return *field;
    const std::string near = parameters::nearest_key(key);
    throw Error(ErrorKind::input,
                {"\"" + key + "\" is no quantity of a case", "only quantities can be followed",
                 near.empty() ? "`stridor init squeal` shows all keys." : "Did you mean \"" + near + "\"?"});
}

Range parse_range(const parameters::Case& c, const std::string& over) {
    const std::size_t equals = over.find('=');
    if (equals == std::string::npos) throw bad_range(over);
    const std::vector<std::string> parts = split(over.substr(equals + 1), ':');
    if (parts.size() < 2 || parts.size() > 3) throw bad_range(over);
    Range range;
    range.field = &quantity_named(over.substr(0, equals));
    const std::string_view unit = std::get<parameters::Quantity>(range.field->kind).unit;
    range.from = base::parse_quantity(parts[0], unit);
    range.to = base::parse_quantity(parts[1], unit);
    if (parts.size() == 3) {
        const std::string& text = parts[2];
        const auto result = std::from_chars(text.data(), text.data() + text.size(), range.points);
        const bool is_whole = result.ec == std::errc{} && result.ptr == text.data() + text.size();
        if (!is_whole || range.points < 2 || range.points > most_points) throw bad_range(over);
    }
    if (!(range.from < range.to)) throw bad_range(over);
    // both ends must be values the parameter can take
    parameters::Case copy = c;
    parameters::set_quantity(copy, *range.field, range.from);
    parameters::set_quantity(copy, *range.field, range.to);
    return range;
}

}  // namespace

io::StabilityScan scan_stability(const parameters::Case& c, const std::string& over) {
    io::StabilityScan scan;
    scan.base = c;
    Range range;
    if (!over.empty()) {
        range = parse_range(c, over);
        scan.key = parameters::key_of(*range.field);
        scan.unit = std::get<parameters::Quantity>(range.field->kind).unit;
    }
    for (const parameters::Direction direction : {parameters::Direction::going, parameters::Direction::coming}) {
        io::DirectionScan along{direction, analysis::sliding_stability(model::rubbing_system(c), direction), {}};
        const auto at = [&](double value) {
            parameters::Case changed = c;
            parameters::set_quantity(changed, *range.field, value);
            return analysis::sliding_stability(model::rubbing_system(changed), direction);
        };
        if (range.field != nullptr) along.path = analysis::stability_path(at, range.from, range.to, range.points);
        scan.directions.push_back(std::move(along));
    }
    return scan;
}

}  // namespace stridor::app
