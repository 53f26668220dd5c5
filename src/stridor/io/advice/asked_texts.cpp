#include "stridor/io/advice/asked_texts.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace stridor::io {

namespace {

Error unreadable_text(const std::string& option, const std::string& text, const std::string& expected,
                      const std::string& example) {
    return {ErrorKind::input, {option + " \"" + text + "\" cannot be read", "expected " + expected, example}};
}

std::string_view unit_named(const parameters::Case& c, const std::string& name) {
    return parameters::unit_of(advice::quantity_key_called(c, name));
}

advice::AskedRange range_from(const parameters::Case& c, const std::string& text) {
    const std::optional<RangeText> said = split_range(text);
    if (!said) return {std::string(base::trimmed(text))};
    if (said->parts.size() != 2)
        throw unreadable_text("--over", text, "KEY or KEY=FROM:TO", "For example contact.kinetic_friction=0:0.8.");
    advice::AskedRange range{std::string(said->key)};
    const RangeEnds ends = read_range_ends(said->parts[0], said->parts[1], unit_named(c, range.name));
    range.from = ends.from;
    range.to = ends.to;
    return range;
}

// "10%", "10 % normal", "2 N"
advice::AskedTolerance tolerance_from(const parameters::Case& c, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        throw unreadable_text("--tolerance", text, "KEY=AMOUNT, in percent or with a unit", "For example preload=10%.");
    advice::AskedTolerance tolerance{std::string(base::trimmed(text.substr(0, equals)))};
    std::string amount(base::trimmed(text.substr(equals + 1)));
    for (std::size_t k = 0; k < advice::spread_names.size(); ++k) {
        const std::string_view name = advice::spread_names[k];
        if (!amount.ends_with(name)) continue;
        tolerance.spread = static_cast<advice::Spread>(k);
        amount = std::string(base::trimmed(amount.substr(0, amount.size() - name.size())));
    }
    if (amount.empty())
        throw unreadable_text("--tolerance", text, "KEY=AMOUNT, in percent or with a unit", "For example preload=10%.");
    if (amount.ends_with('%'))
        tolerance.relative = base::parse_quantity(amount, "1");
    else
        tolerance.absolute = base::parse_quantity(amount, unit_named(c, tolerance.name));
    return tolerance;
}

// the choices of a list, each once
template <typename Choice>
std::vector<Choice> choices_of(const std::string& option, const std::vector<std::string>& texts,
                               std::span<const std::string_view> names) {
    std::vector<Choice> all;
    for (const std::string& text : texts) {
        const auto each = static_cast<Choice>(
            base::place_of_choice(option, std::string(base::trimmed(text)), names, base::Place{option, 0, 0, text}));
        if (std::find(all.begin(), all.end(), each) == all.end()) all.push_back(each);
    }
    return all;
}

// what is wrong with an option is told with the option's name
template <typename Read>
auto placed(const char* option, const std::string& text, Read read) {
    try {
        return read();
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), base::Place{option, 0, 0, text});
    }
}

}  // namespace

advice::AskedRange read_asked_range(const parameters::Case& c, const std::string& text) {
    return placed("--over", text, [&] { return range_from(c, text); });
}

advice::AskedTolerance read_asked_tolerance(const parameters::Case& c, const std::string& text) {
    return placed("--tolerance", text, [&] { return tolerance_from(c, text); });
}

advice::AskedRuns read_asked_runs(const std::vector<std::string>& directions, const std::vector<std::string>& starts) {
    return {choices_of<parameters::Direction>("--direction", directions, parameters::direction_names),
            choices_of<parameters::Initial>("--start", starts, sweep::start_names())};
}

}  // namespace stridor::io
