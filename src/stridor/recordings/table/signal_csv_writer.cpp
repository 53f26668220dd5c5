#include "stridor/recordings/table/signal_csv_writer.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/base/text.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <algorithm>
#include <vector>

namespace stridor::recordings {

namespace {

constexpr std::size_t csv_block = 1U << 12U;

// names of channels have no line ends and quotes here: the reader takes a row for a line
std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '"'; }, ' ');
    return text;
}

// a column without a unit is read as one of full scale, so that of a dimensionless signal says so
std::string heading(const signal::Channel& channel, std::size_t number) {
    const std::string name = channel.name.empty() ? "channel " + std::to_string(number) : channel.name;
    return one_line(name + " [" + channel.unit + "]");
}

base::csv_text::Table table_of(const signal::ChannelLayout& layout) {
    base::csv_text::Facts facts = base::csv_text::origin("signal");
    facts.emplace_back("rate", base::shortest(layout.rate) + " Hz");
    std::vector<base::csv_text::TableColumn> columns{{"time", "s"}};
    for (std::size_t k = 0; k < layout.channels.size(); ++k)
        columns.push_back({heading(layout.channels[k], k + 1)});
    return base::csv_text::Table(facts, columns);
}

}  // namespace

std::uint64_t write_signal_csv(const std::string& path, signal::Source& source) {
    storage::PiecewiseFile file(path);
    const signal::ChannelLayout& layout = source.layout();
    const std::size_t width = layout.channels.size();
    base::csv_text::Table table = table_of(layout);
    file.write(table.take());
    std::vector<double> block(csv_block * width);
    std::uint64_t frames = 0;
    while (const std::size_t count = source.read(block)) {
        for (std::size_t frame = 0; frame < count; ++frame, ++frames) {
            table.number(static_cast<double>(frames) / layout.rate);
            for (std::size_t channel = 0; channel < width; ++channel)
                table.number(block[frame * width + channel]);
            table.end_row();
        }
        file.write(table.take());
    }
    file.commit();
    return frames;
}

}  // namespace stridor::recordings
