#include "stridor/base/error.hpp"
#include "stridor/explorer/answers/answers.hpp"
#include "stridor/explorer/sent_columns.hpp"
#include "stridor/parameters/own_structure.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace stridor::explorer {

namespace {

constexpr double most_samples = 1e6;     // of a trace
constexpr double most_numbers = 1.2e7;   // of all its columns: of many contacts the samples are fewer
constexpr double least_interval = 1e-7;  // [s] between them

record::TraceRequest trace_in(const Json& body, const parameters::Case& c, std::size_t columns) {
    const double from = std::max(0.0, number_in(body, "from", 0.0));
    const double to = std::min(c.run.duration, number_in(body, "to", c.run.duration));
    const double interval = number_in(body, "interval", std::max(least_interval, (to - from) / most_samples));
    const bool is_possible = from < to && interval >= least_interval && (to - from) / interval <= 1.01 * most_samples;
    if (!is_possible)
        throw Error(ErrorKind::input, {"there is no such trace",
                                       "its times must rise within the run, and a million samples "
                                       "are the most",
                                       ""});
    record::TraceRequest request;
    request.from = from;
    request.to = to;
    request.interval = std::max(interval, (to - from) * static_cast<double>(columns) / most_numbers);
    return request;
}

void pad(std::string& bytes) {
    bytes.resize((bytes.size() + 7) / 8 * 8, '\0');
}

// points of the line as which the structure is drawn, at rest
Json outline_array(const parameters::OwnStructure& own) {
    Json outline = Json::array();
    for (const parameters::OutlinePoint& point : own.outline)
        outline.push_back(point.position);
    return outline;
}

std::string motion_header(const parameters::Case& c, const record::TraceRequest& trace,
                          const std::vector<SentColumn>& columns, std::size_t samples,
                          const std::vector<record::ContactHistory>& histories) {
    Json header{{"schema", "stridor.explorer.motion/1"},
                {"samples", samples},
                {"start", trace.from},
                {"interval", trace.interval},
                {"columns", Json::array()}};
    for (const SentColumn& column : columns)
        header["columns"].push_back({{"name", column.name}, {"unit", column.unit}, {"sentence", column.sentence}});
    header["contacts"] = Json::array();
    for (std::size_t k = 0; k < histories.size(); ++k)
        header["contacts"].push_back({{"name", parameters::contact_name(c, k)}, {"intervals", histories[k].size()}});
    if (c.own_structure && !c.own_structure->outline.empty()) header["outline"] = outline_array(*c.own_structure);
    header["states"] = model::contact_state_names;
    std::string text = header.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 4 + 7) / 8 * 8 - 4, ' ');  // the arrays after it begin at a multiple of 8
    return text;
}

std::string history_bytes(const record::ContactHistory& history) {
    std::vector<double> times;
    std::vector<std::uint8_t> states;
    for (const record::ContactInterval& interval : history) {
        times.push_back(interval.from);
        states.push_back(static_cast<std::uint8_t>(interval.state));
    }
    times.push_back(history.empty() ? 0.0 : history.back().to);
    return bytes_of<double>(times) + bytes_of<std::uint8_t>(states);
}

}  // namespace

Response motion(const World& world, const Json& body, const std::stop_token& stop) {
    const parameters::Case c = case_in(world, body);
    const std::vector<SentColumn> columns = sent_columns(c);
    record::Request request{record::KeepHistory::yes, trace_in(body, c, columns.size())};
    std::vector<std::vector<float>> values(columns.size());
    // block by block into the half as large numbers that are sent: a trace of doubles would be 100 MB
    request.trace.taker = [&](const record::Trace& trace) {
        for (std::size_t k = 0; k < columns.size(); ++k)
            columns[k].add(trace, values[k]);
    };
    const integration::Motion motion = run_case(c, request, stop);
    const std::string header = motion_header(c, request.trace, columns, values.front().size(), motion.record.histories);
    const auto length = static_cast<std::uint32_t>(header.size());
    std::string bytes = bytes_of<std::uint32_t>({&length, 1}) + header;
    for (const std::vector<float>& column : values) {
        bytes += bytes_of<float>(column);
        pad(bytes);
    }
    for (const record::ContactHistory& history : motion.record.histories) {
        bytes += history_bytes(history);
        pad(bytes);
    }
    return {200, "application/octet-stream", std::move(bytes)};
}

}  // namespace stridor::explorer
