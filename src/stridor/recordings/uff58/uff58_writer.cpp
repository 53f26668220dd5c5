#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/base/version.hpp"
#include "stridor/recordings/bytes.hpp"
#include "stridor/recordings/uff58/uff58.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

namespace stridor::recordings {

namespace {

constexpr std::size_t uff58_block = 1U << 14U;
constexpr std::uint64_t most_values = 9'999'999'999;  // the field of the count has ten columns

/// Type of an ordinate (record 9, field 1) by its unit; general where there is none.
int ordinate_type(std::string_view unit) {
    constexpr std::array types{std::pair{"m", 8}, std::pair{"m/s", 11}, std::pair{"m/s^2", 12}, std::pair{"N", 9},
                               std::pair{"Pa", 15}};
    for (const auto& [name, type] : types)
        if (unit == name) return type;
    return 1;
}

std::string right(std::string_view text, std::size_t width) {
    return text.size() < width ? std::string(width - text.size(), ' ') + std::string(text) : std::string(text);
}

std::string left(std::string_view text, std::size_t width) {
    std::string result(text.substr(0, width));
    // a control character would end the card
    std::replace_if(
        result.begin(), result.end(), [](char c) { return static_cast<unsigned char>(c) < 32; }, ' ');
    return result + std::string(width - result.size(), ' ');
}

std::string whole(long long number, std::size_t width) {
    return right(std::to_string(number), width);
}

// 1PE13.5 or 1PE20.12
std::string scientific(double value, int digits, std::size_t width) {
    std::array<char, 40> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits).ptr;
    std::replace(text.begin(), text.end(), 'e', 'E');
    return right({text.data(), static_cast<std::size_t>(end - text.data())}, width);
}

std::string card(std::string_view text) {
    return left(text.empty() ? "NONE" : text, 80) + "\n";
}

std::string labels(int type, std::string_view label, std::string_view unit) {
    return whole(type, 10) + whole(0, 5) + whole(0, 5) + whole(0, 5) + " " + left(label.empty() ? "NONE" : label, 20) +
           " " + left(unit.empty() ? "NONE" : unit, 20) + "\n";
}

/// What a header is made of.
struct Shape {
    double rate = 0.0;        // [Hz]
    std::uint64_t count = 0;  // [1] values of each channel
    Uff58Form form = Uff58Form::ascii;
};

std::string header(const signal::Channel& channel, const Shape& shape, std::size_t index) {
    const bool is_binary = shape.form == Uff58Form::binary;
    const auto bytes = static_cast<long long>(shape.count * sizeof(double));
    std::string text = whole(-1, 6) + "\n" + whole(58, 6);
    if (is_binary)
        text += "b" + whole(1, 6) + whole(2, 6) + whole(11, 12) + whole(bytes, 12) + whole(0, 6) + whole(0, 6) +
                whole(0, 12) + whole(0, 12);
    text += "\n";
    const std::string name = channel.name.empty() ? "channel " + std::to_string(index + 1) : channel.name;
    text += card(name) + card("stridor " + std::string(base::version())) + card("");
    text += card("rate: " + base::shortest(shape.rate) + " Hz") + card("");
    text += whole(1, 5) + whole(0, 10) + whole(0, 5) + whole(0, 10) + " " + left("NONE", 10) + whole(0, 10) +
            whole(0, 4) + " " + left("NONE", 10) + whole(0, 10) + whole(0, 4) + "\n";
    text += whole(4, 10) + whole(static_cast<long long>(shape.count), 10) + whole(1, 10) + scientific(0.0, 5, 13) +
            scientific(1.0 / shape.rate, 5, 13) + scientific(0.0, 5, 13) + "\n";
    text += labels(17, "Time", "s");
    text += labels(ordinate_type(channel.unit), name, channel.unit == signal::full_scale ? "" : channel.unit);
    return text + labels(0, "", "") + labels(0, "", "");
}

/// The values of one channel on their way into the file.
class Body {
public:
    Body(storage::PiecewiseFile& file, Uff58Form form) : file_(file), form_(form) {}

    void value(double value) {
        if (!std::isfinite(value))
            throw Error(ErrorKind::input, {"a sample is not a finite number", "dataset 58 has no word for it", ""});
        if (form_ == Uff58Form::binary) return write_binary(value);
        file_.write(scientific(value, 12, 20));
        if (++on_line_ < 4) return;
        file_.write("\n");
        on_line_ = 0;
    }

    void end() {
        if (on_line_ > 0 || form_ == Uff58Form::binary) file_.write("\n");
        file_.write(whole(-1, 6) + "\n");
    }

private:
    void write_binary(double value) {
        static_assert(std::endian::native == std::endian::little, "the header says little endian");
        std::array<char, sizeof value> bytes{};
        std::memcpy(bytes.data(), &value, sizeof value);
        file_.write({bytes.data(), bytes.size()});
    }

    storage::PiecewiseFile& file_;
    Uff58Form form_;
    int on_line_ = 0;  // [1] values
};

// all frames, as they come, for the channels one after the other
std::unique_ptr<Spool> spooled(signal::Source& source) {
    auto spool = std::make_unique<Spool>();
    std::vector<double> block(uff58_block * source.layout().channels.size());
    while (const std::size_t count = source.read(block)) {
        const std::size_t used = count * source.layout().channels.size();
        std::string bytes(used * sizeof(double), '\0');
        std::memcpy(bytes.data(), block.data(), bytes.size());
        spool->append(bytes);
    }
    return spool;
}

void write_channel(Body& body, const Spool& spool, std::size_t channel, std::size_t width) {
    const std::size_t frame_bytes = width * sizeof(double);
    std::string block(uff58_block * frame_bytes, '\0');
    for (std::uint64_t offset = 0; offset < spool.size(); offset += block.size()) {
        const std::size_t count = spool.read_at(offset, block) / frame_bytes;
        for (std::size_t frame = 0; frame < count; ++frame) {
            double value = 0.0;
            std::memcpy(&value, block.data() + frame * frame_bytes + channel * sizeof value, sizeof value);
            body.value(value);
        }
    }
    body.end();
}

}  // namespace

std::uint64_t write_uff58(const std::string& path, signal::Source& source, Uff58Form form) {
    storage::PiecewiseFile file(path);
    const signal::ChannelLayout& layout = source.layout();
    const std::size_t width = layout.channels.size();
    const std::unique_ptr<Spool> spool = spooled(source);
    const Shape shape{layout.rate, spool->size() / (width * sizeof(double)), form};
    if (shape.count == 0 || shape.count > most_values)
        throw Error(ErrorKind::input, {"dataset 58 cannot hold " + std::to_string(shape.count) + " values", "", ""});
    for (std::size_t channel = 0; channel < width; ++channel) {
        file.write(header(layout.channels[channel], shape, channel));
        Body body(file, form);
        write_channel(body, *spool, channel, width);
    }
    file.commit();
    return shape.count;
}

}  // namespace stridor::recordings
