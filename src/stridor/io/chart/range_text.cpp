#include "stridor/io/chart/range_text.hpp"

#include "stridor/advice/design_space.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/case_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace stridor::io {

namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(separator, start), text.size());
        parts.push_back(base::trimmed(text.substr(start, end - start)));
        start = end + 1;
    }
    return parts;
}

// what stands behind the number: "N" of "40 N"
std::string_view unit_behind(std::string_view text) {
    double number = 0.0;
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto read = std::from_chars(begin, text.data() + text.size(), number);
    if (read.ec != std::errc{}) return {};
    return base::trimmed(text.substr(static_cast<std::size_t>(read.ptr - text.data())));
}

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

constexpr double most_trace_samples = 2e6;  // 0.9 GB with the text of their file
constexpr double countable = 1e15;          // [1] intervals that a double counts

}  // namespace

std::optional<RangeText> split_range(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    return RangeText{base::trimmed(text.substr(0, equals)), split(text.substr(equals + 1), ':')};
}

RangeEnds read_range_ends(std::string_view from, std::string_view to, std::string_view unit) {
    std::string first(from);
    if (unit_behind(first).empty()) first += " " + std::string(unit_behind(to));
    return {base::parse_quantity(base::trimmed(first), unit), base::parse_quantity(to, unit)};
}

std::optional<int> read_points(std::string_view text, int most) {
    int points = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), points);
    const bool is_whole = read.ec == std::errc{} && read.ptr == text.data() + text.size();
    return is_whole && points >= 2 && points <= most ? std::optional(points) : std::nullopt;
}

sweep::Axis read_axis_text(const parameters::Case& c, const std::string& text, int points, const std::string& option) {
    const auto refusal = [&](const std::string& why) {
        return Error(ErrorKind::input, {option + " \"" + text + "\" cannot be read", why,
                                        "For example " + option + " preload=1:40 or " + option + " mu_d=0.2:0.8:30."});
    };
    const std::optional<RangeText> range = split_range(text);
    if (!range || range->parts.size() < 2 || range->parts.size() > 4)
        throw refusal("expected KEY=FROM:TO[:POINTS[:SCALE]]");
    const std::vector<std::string_view>& parts = range->parts;
    const std::string key = advice::quantity_key_called(c, range->key);
    const auto& quantity = std::get<parameters::Quantity>(parameters::field_of(key)->kind);

    sweep::Axis axis{key, 0.0, 1.0, points, sweep::Scale::linear};
    try {
        const RangeEnds ends = read_range_ends(parts[0], parts[1], quantity.unit);
        axis.from = ends.from;
        axis.to = ends.to;
    } catch (const Error& error) {
        throw refusal(error.problem().what + (error.problem().why.empty() ? "" : " (" + error.problem().why + ")"));
    }
    if (!(axis.from < axis.to))
        throw refusal(axis.from > axis.to ? "an axis rises; write the smaller end first"
                                          : "both ends are the same, which makes no axis");
    if (quantity.usual && quantity.usual->scale == sweep::Scale::logarithmic && axis.from > 0.0)
        axis.scale = sweep::Scale::logarithmic;
    if (parts.size() > 2) {
        const std::optional<int> asked = read_points(parts[2], sweep::most_points);
        if (!asked)
            throw refusal("\"" + std::string(parts[2]) + "\" is no number of points from 2 to " +
                          std::to_string(sweep::most_points));
        axis.points = *asked;
    }
    if (parts.size() > 3) {
        const auto found = std::find(sweep::scale_names.begin(), sweep::scale_names.end(), parts[3]);
        if (found == sweep::scale_names.end())
            throw refusal("\"" + std::string(parts[3]) + "\" is no scale: linear or log");
        axis.scale = static_cast<sweep::Scale>(found - sweep::scale_names.begin());
    }
    return axis;
}

std::string write_axis_text(const sweep::Axis& axis) {
    return axis.parameter + "=" + base::shortest(axis.from) + ":" + base::shortest(axis.to) + ":" +
           std::to_string(axis.points) + ":" + std::string(sweep::scale_names[static_cast<std::size_t>(axis.scale)]);
}

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

record::TraceRequest trace_request(const TraceTexts& texts, const parameters::Case& c) {
    record::TraceRequest trace;
    trace.from = texts.from.empty() ? 0.0 : base::parse_quantity(texts.from, "s");
    trace.to = texts.to.empty() ? c.run.duration : base::parse_quantity(texts.to, "s");
    trace.interval = base::parse_quantity(texts.interval, "s");
    const bool is_ordered = trace.interval > 0.0 && trace.from <= trace.to;
    if (!is_ordered)
        throw Error(ErrorKind::input, {"the trace has no samples",
                                       "its interval must be positive and --trace-from before --trace-to", ""});
    const double samples = (trace.to - trace.from) / trace.interval;
    if (samples > most_trace_samples || !(std::abs(trace.to / trace.interval) <= countable))
        throw Error(ErrorKind::input,
                    {fmt::format("the trace has {:.3g} samples", samples),
                     fmt::format("a trace is kept in memory, {:.0f} samples at most", most_trace_samples),
                     "Lengthen --trace-interval, or shorten the time from --trace-from to --trace-to."});
    return trace;
}

}  // namespace stridor::io
