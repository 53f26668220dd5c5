#include "stridor/io/signal_csv_writer.hpp"

#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/base/version.hpp"
#include "stridor/io/atomic_file.hpp"

#include <array>
#include <charconv>
#include <string_view>
#include <vector>

namespace stridor::io {

namespace {

constexpr std::size_t block_frames = 1U << 12U;

// RFC 4180, but on one line: names of channels have no line ends here
std::string quoted(std::string_view text) {
    std::string plain;
    for (const char c : text)
        plain += c == '\n' || c == '\r' || c == '"' ? ' ' : c;
    plain = base::spreadsheet_text(plain);
    return plain.find_first_of(",;\t#") == std::string::npos ? plain : "\"" + plain + "\"";
}

std::string opening(const signal::Layout& layout) {
    std::string text = "# schema: stridor.signal/1\n# version: " + std::string(base::version()) + "\n";
    text += "# rate: " + base::shortest(layout.rate) + " Hz\ntime";
    for (std::size_t channel = 0; channel < layout.channels.size(); ++channel) {
        const std::string& name = layout.channels[channel].name;
        text += "," + (name.empty() ? "channel " + std::to_string(channel + 1) : quoted(name));
    }
    text += "\ns";
    for (const signal::Channel& channel : layout.channels)
        text += "," + quoted(channel.unit);
    return text + "\n";
}

void append(std::string& text, double number) {
    std::array<char, 32> buffer{};
    text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr);
}

}  // namespace

std::uint64_t write_signal_csv(const std::string& path, signal::Source& source) {
    PiecewiseFile file(path);
    const signal::Layout& layout = source.layout();
    const std::size_t width = layout.channels.size();
    file.write(opening(layout));
    std::vector<double> block(block_frames * width);
    std::uint64_t frames = 0;
    std::string text;
    while (const std::size_t count = source.read(block)) {
        text.clear();
        for (std::size_t frame = 0; frame < count; ++frame, ++frames) {
            append(text, static_cast<double>(frames) / layout.rate);
            for (std::size_t channel = 0; channel < width; ++channel) {
                text += ',';
                append(text, block[frame * width + channel]);
            }
            text += '\n';
        }
        file.write(text);
    }
    file.commit();
    return frames;
}

}  // namespace stridor::io
