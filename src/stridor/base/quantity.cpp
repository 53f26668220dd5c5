#include "stridor/base/quantity.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stridor::base {

namespace {

struct Symbol {
    std::string_view name;
    Unit unit;
    bool takes_prefix = false;
};

constexpr double degrees_per_radian = 57.295779513082320876798;

constexpr std::array symbols{
    Symbol{"1", {{}, 1.0}, false},
    Symbol{"%", {{}, 0.01}, false},
    Symbol{"m", {{0, 1, 0, 0}, 1.0}, true},
    Symbol{"g", {{1, 0, 0, 0}, 1e-3}, true},
    Symbol{"t", {{1, 0, 0, 0}, 1e3}, false},
    Symbol{"s", {{0, 0, 1, 0}, 1.0}, true},
    Symbol{"min", {{0, 0, 1, 0}, 60.0}, false},
    Symbol{"h", {{0, 0, 1, 0}, 3600.0}, false},
    Symbol{"N", {{1, 1, -2, 0}, 1.0}, true},
    Symbol{"daN", {{1, 1, -2, 0}, 10.0}, false},
    // products that people write without a sign between
    Symbol{"Ns", {{1, 1, -1, 0}, 1.0}, true},
    Symbol{"Nm", {{1, 2, -2, 0}, 1.0}, true},
    Symbol{"Pa", {{1, -1, -2, 0}, 1.0}, true},
    Symbol{"J", {{1, 2, -2, 0}, 1.0}, true},
    Symbol{"W", {{1, 2, -3, 0}, 1.0}, true},
    Symbol{"Hz", {{0, 0, -1, 0}, 1.0}, true},
    Symbol{"rpm", {{0, 0, -1, 0}, 1.0 / 60.0}, false},
    Symbol{"A", {{0, 0, 0, 0, 1}, 1.0}, true},
    Symbol{"V", {{1, 2, -3, 0, -1}, 1.0}, true},
    Symbol{"deg", {{0, 0, 0, 1}, 1.0}, false},
    Symbol{"°", {{0, 0, 0, 1}, 1.0}, false},
    Symbol{"rad", {{0, 0, 0, 1}, degrees_per_radian}, true},
    Symbol{"lbf", {{1, 1, -2, 0}, 4.4482216152605}, false},
    Symbol{"kgf", {{1, 1, -2, 0}, 9.80665}, false},
    Symbol{"psi", {{1, -1, -2, 0}, 6894.757293168361}, false},
    Symbol{"bar", {{1, -1, -2, 0}, 1e5}, false},
    Symbol{"in", {{0, 1, 0, 0}, 0.0254}, false},
    Symbol{"ft", {{0, 1, 0, 0}, 0.3048}, false},
    Symbol{"degC", {{0, 0, 0, 0, 0, 1}, 1.0}, false},
    Symbol{"°C", {{0, 0, 0, 0, 0, 1}, 1.0}, false},
    // of a rise: by itself it is none (`try_unit`)
    Symbol{"K", {{0, 0, 0, 0, 0, 1}, 1.0}, false},
};

constexpr std::array prefixes{
    std::pair{std::string_view{"G"}, 1e9},  std::pair{std::string_view{"M"}, 1e6},
    std::pair{std::string_view{"k"}, 1e3},  std::pair{std::string_view{"c"}, 1e-2},
    std::pair{std::string_view{"m"}, 1e-3}, std::pair{std::string_view{"u"}, 1e-6},
    std::pair{std::string_view{"µ"}, 1e-6}, std::pair{std::string_view{"n"}, 1e-9},
};

struct Name {
    Dimension dimension;
    std::string_view text;
};

constexpr std::array names{
    Name{{}, "a plain number"},
    Name{{1, 0, 0, 0}, "a mass (kg)"},
    Name{{0, 1, 0, 0}, "a length (m)"},
    Name{{0, 0, 1, 0}, "a time (s)"},
    Name{{0, 0, 0, 1}, "an angle (deg)"},
    Name{{1, 1, -2, 0}, "a force (N)"},
    Name{{1, 0, -2, 0}, "a stiffness (N/m)"},
    Name{{1, 0, -1, 0}, "a damping (N*s/m)"},
    Name{{0, 1, -1, 0}, "a velocity (m/s)"},
    Name{{0, 1, -2, 0}, "an acceleration (m/s^2)"},
    Name{{0, 0, -1, 0}, "a frequency (Hz)"},
    Name{{1, -1, -2, 0}, "a pressure (Pa)"},
    Name{{1, 2, -2, 0}, "an energy (J)"},
    Name{{1, 2, -3, 0}, "a power (W)"},
    Name{{0, 0, 0, 0, 1}, "a current (A)"},
    Name{{1, 2, -3, 0, -1}, "a voltage (V)"},
    Name{{0, 0, 0, 0, 0, 1}, "a temperature (degC)"},
};

/// A unit, or the part of its text that is unknown.
struct ConversionAttempt {
    std::optional<Unit> unit{};
    std::string_view unknown{};
};

std::optional<Unit> find_symbol(std::string_view text) {
    for (const Symbol& symbol : symbols)
        if (symbol.name == text) return symbol.unit;
    for (const auto& [prefix, factor] : prefixes) {
        if (!text.starts_with(prefix)) continue;
        for (const Symbol& symbol : symbols) {
            const bool matches = symbol.takes_prefix && symbol.name == text.substr(prefix.size());
            // kg is exactly 1, not 1000 * 0.001 by luck of rounding
            if (matches) return Unit{symbol.unit.dimension, text == "kg" ? 1.0 : factor * symbol.unit.factor};
        }
    }
    return std::nullopt;
}

// one symbol with an optional power: "mm", "s^2", "s²", "s^-1"
ConversionAttempt try_factor(std::string_view text) {
    int power = 1;
    const std::size_t caret = text.find('^');
    if (caret != std::string_view::npos) {
        const std::string_view digits = text.substr(caret + 1);
        const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), power);
        const bool is_whole = result.ec == std::errc{} && result.ptr == digits.data() + digits.size();
        if (!is_whole || std::abs(power) > 9) return {{}, text};
        text = text.substr(0, caret);
    } else if (text.ends_with("²")) {
        power = 2;
        text.remove_suffix(std::string_view("²").size());
    }
    const std::optional<Unit> symbol = find_symbol(text);
    if (!symbol) return {{}, text};
    const Unit& base = *symbol;
    Unit unit{{base.dimension.mass * power, base.dimension.length * power, base.dimension.time * power,
               base.dimension.angle * power, base.dimension.current * power, base.dimension.temperature * power},
              1.0};
    for (int k = 0; k < std::abs(power); ++k)
        unit.factor *= base.factor;
    if (power < 0) unit.factor = 1.0 / unit.factor;
    return {unit, {}};
}

Unit product(const Unit& a, const Unit& b, int sign) {
    return {
        {a.dimension.mass + sign * b.dimension.mass, a.dimension.length + sign * b.dimension.length,
         a.dimension.time + sign * b.dimension.time, a.dimension.angle + sign * b.dimension.angle,
         a.dimension.current + sign * b.dimension.current, a.dimension.temperature + sign * b.dimension.temperature},
        sign > 0 ? a.factor * b.factor : a.factor / b.factor};
}

ConversionAttempt try_unit(std::string_view text) {
    text = trimmed(text);
    // 300 K are not 300 degC
    if (text.empty() || text == "K") return {{}, text};
    Unit unit;
    int sign = 1;
    while (true) {
        std::size_t end = text.find_first_of(" */");
        const std::size_t dot = text.find("·");
        if (dot < end) end = dot;
        const ConversionAttempt factor = try_factor(text.substr(0, end));
        if (!factor.unit) return factor;
        unit = product(unit, *factor.unit, sign);
        if (end == std::string_view::npos) return {unit, {}};
        // one separator, blanks around it allowed; a blank alone is a product
        std::string_view rest = trimmed(text.substr(end));
        sign = rest.starts_with('/') ? -1 : 1;
        if (rest.starts_with('/') || rest.starts_with('*')) rest.remove_prefix(1);
        if (rest.starts_with("·")) rest.remove_prefix(std::string_view("·").size());
        text = trimmed(rest);
        if (text.empty()) return {{}, rest};
    }
}

// the power of ten that a ratio of units is, up to the rounding of its factors; nothing for minutes and radians
std::optional<int> decimal_exponent(double ratio) {
    const int exponent = static_cast<int>(std::lround(std::log10(ratio)));
    const double power = std::strtod(("1e" + std::to_string(exponent)).c_str(), nullptr);
    return std::abs(ratio / power - 1.0) < 1e-14 ? std::optional(exponent) : std::nullopt;
}

// number times ratio; a decimal ratio moves the numeral's own exponent, so that "0.1 us" reads as 1e-07 to the last bit
double scaled(std::string_view numeral, double number, double ratio) {
    const std::optional<int> shift = decimal_exponent(ratio);
    // 1/60 has no exact double, 60 has
    const double inverse = 1.0 / ratio;
    if (!shift) return inverse == std::round(inverse) ? number / inverse : number * ratio;
    if (*shift == 0) return number;
    const std::size_t mark = numeral.find_first_of("eE");
    int exponent = 0;
    if (mark != std::string_view::npos) {
        const std::size_t sign = numeral[mark + 1] == '+' ? 1 : 0;
        std::from_chars(numeral.data() + mark + 1 + sign, numeral.data() + numeral.size(), exponent);
    }
    const std::string moved = std::string(numeral.substr(0, mark)) + "e" + std::to_string(exponent + *shift);
    double value = number * ratio;  // stays where the moved numeral leaves double precision
    std::from_chars(moved.data(), moved.data() + moved.size(), value);
    return value;
}

// how people spell units out, or shorten them otherwise
struct Spelling {
    std::string_view text;
    std::string_view symbol;
};
constexpr std::array spellings{
    Spelling{"newton", "N"}, Spelling{"newtons", "N"},    Spelling{"metre", "m"},    Spelling{"meter", "m"},
    Spelling{"sec", "s"},    Spelling{"second", "s"},     Spelling{"seconds", "s"},  Spelling{"minutes", "min"},
    Spelling{"hour", "h"},   Spelling{"hours", "h"},      Spelling{"degree", "deg"}, Spelling{"degrees", "deg"},
    Spelling{"hertz", "Hz"}, Spelling{"percent", "%"},    Spelling{"gram", "g"},     Spelling{"kilogram", "kg"},
    Spelling{"C", "degC"},   Spelling{"celsius", "degC"},
};

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
    return result;
}

// every symbol with every prefix it takes
std::vector<std::string> all_symbols() {
    std::vector<std::string> all;
    for (const Symbol& symbol : symbols)
        all.emplace_back(symbol.name);
    for (const Symbol& symbol : symbols)
        for (const auto& [prefix, factor] : prefixes)
            if (symbol.takes_prefix) all.push_back(std::string(prefix) + std::string(symbol.name));
    return all;
}

// what `text`, a unit with an unknown part, is with that part replaced: the same in other letters, a word for it, or
// one that differs by one letter; of the dimension that is wanted, if one is
std::string similar_unit(std::string_view text, std::string_view unknown, const Dimension* wanted) {
    if (unknown.empty()) return {};
    const auto at = static_cast<std::size_t>(unknown.data() - text.data());
    const auto repaired = [&](std::string_view symbol) {
        return std::string(text.substr(0, at)) + std::string(symbol) + std::string(text.substr(at + unknown.size()));
    };
    const auto fits = [&](std::string_view symbol) {
        const std::optional<Unit> unit = try_unit(repaired(symbol)).unit;
        return unit && (wanted == nullptr || unit->dimension == *wanted);
    };
    if (fits(lower(unknown))) return repaired(lower(unknown));  // mm for MM, which Mm is, too
    const std::vector<std::string> all = all_symbols();
    for (const std::string& symbol : all)
        if (lower(symbol) == lower(unknown) && fits(symbol)) return repaired(symbol);
    for (const Spelling& spelling : spellings)
        if (lower(spelling.text) == lower(unknown) && fits(spelling.symbol)) return repaired(spelling.symbol);
    if (unknown.size() < 3) return {};  // one letter of two is another unit
    std::vector<std::string_view> fitting;
    for (const std::string& symbol : all)
        if (symbol.size() > 1 && fits(symbol)) fitting.push_back(symbol);
    const std::string_view near = nearest_name(unknown, fitting, 1);
    return near.empty() ? std::string() : repaired(near);
}

Error bad_unit(std::string_view text, std::string_view unknown, std::string_view wanted) {
    const std::optional<Unit> unit = wanted.empty() ? std::nullopt : try_unit(wanted).unit;
    const std::string near = similar_unit(text, unknown, unit ? &unit->dimension : nullptr);
    const std::string known =
        "Known: m, g, t, s, min, h, N, daN, lbf, kgf, Pa, bar, psi, J, W, Hz, rpm, A, V, in, ft, deg, rad, degC, %, "
        "with G M k c m u n.";
    const bool is_plain = wanted.empty() || wanted == "1";
    std::string help = !near.empty() ? "Did you mean \"" + near + "\"?"
                       : is_plain    ? known
                                     : "Give it in " + std::string(wanted) + ". " + known;
    return {ErrorKind::input, {"unknown unit \"" + std::string(unknown) + "\"", "", std::move(help)}};
}

// "0,5 mm" as it should be written, if that is all that is wrong with it
std::string with_point(std::string_view text) {
    std::string repaired(text);
    const std::size_t comma = repaired.find(',');
    if (comma == std::string::npos) return {};
    repaired[comma] = '.';
    const bool is_one = repaired.find_first_of(",.", comma + 1) == std::string::npos && repaired.find('.') == comma &&
                        repaired.find_first_of("0123456789", comma) == comma + 1;
    return is_one ? repaired : std::string();
}

}  // namespace

std::string describe(Dimension dimension) {
    for (const Name& name : names)
        if (name.dimension == dimension) return std::string(name.text);
    std::string text = "a quantity in";
    const std::array parts{std::pair{"kg", dimension.mass},   std::pair{"m", dimension.length},
                           std::pair{"s", dimension.time},    std::pair{"deg", dimension.angle},
                           std::pair{"A", dimension.current}, std::pair{"degC", dimension.temperature}};
    for (const auto& [symbol, power] : parts)
        if (power != 0) text += std::string(" ") + symbol + (power == 1 ? "" : "^" + std::to_string(power));
    return text;
}

std::optional<Unit> find_unit(std::string_view text) {
    return try_unit(text).unit;
}

Unit parse_unit(std::string_view text) {
    const ConversionAttempt attempt = try_unit(text);
    if (!attempt.unit) throw bad_unit(text, attempt.unknown, "");
    return *attempt.unit;
}

double parse_quantity(std::string_view text, std::string_view unit) {
    const std::string_view given = trimmed(text);
    double number = 0.0;
    // from_chars refuses a leading plus, which people write
    const bool has_plus = given.starts_with('+') && !given.starts_with("+-");
    const std::string_view digits = given.substr(has_plus ? 1 : 0);
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const std::string quoted = "\"" + std::string(given) + "\"";
    const bool is_word =
        result.ec == std::errc::invalid_argument || digits.starts_with("inf") || digits.starts_with("nan");
    if (is_word)
        throw Error(ErrorKind::input,
                    {quoted + " is not a number", "", "Write a number, with or without a unit: \"4 mm\"."});
    const std::string_view rest = trimmed(digits.substr(static_cast<std::size_t>(result.ptr - digits.data())));
    if (rest.starts_with(',')) {
        const std::string repaired = with_point(given);
        throw Error(ErrorKind::input,
                    {quoted + " has a comma", "numbers are written with a decimal point and no other marks",
                     "Write " + (repaired.empty() ? "1234.5, not 1,234.5" : "\"" + repaired + "\"") + "."});
    }
    const Unit wanted = parse_unit(unit);
    const ConversionAttempt attempt = rest.empty() ? ConversionAttempt{wanted, {}} : try_unit(rest);
    if (!attempt.unit) throw bad_unit(rest, attempt.unknown, unit);
    const Unit found = *attempt.unit;
    if (!(found.dimension == wanted.dimension))
        throw Error(ErrorKind::input,
                    {quoted + " is " + describe(found.dimension), "expected " + describe(wanted.dimension),
                     unit == "1" ? std::string("Give a plain number.") : "Give it in " + std::string(unit) + "."});
    const std::string_view numeral(digits.data(), result.ptr);
    const double value = scaled(numeral, number, found.factor / wanted.factor);
    if (result.ec == std::errc::result_out_of_range || !std::isfinite(value))
        throw Error(ErrorKind::input, {quoted + " is not a finite number", "it lies outside double precision", ""});
    return value;
}

}  // namespace stridor::base
