#include "stridor/recordings/uff58/uff58.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/uff58/uff58_header.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace stridor::recordings {

namespace {

using uff58::Dataset;
using uff58::Form;

constexpr std::size_t most_channels = 256;  // each has a block of its own

/// The values of one dataset from the first to the last.
class Values {
public:
    virtual ~Values() = default;
    /// Puts the next `count` values at every `stride`-th place of `into`.
    virtual void read(std::span<double> into, std::size_t count, std::size_t stride) = 0;
};

class AsciiValues final : public Values {
public:
    AsciiValues(const SignalInput& input, const Dataset& dataset)
        : dataset_(dataset),
          lines_(input.bytes, input.name, dataset.data_offset, dataset.data_line) {}

    void read(std::span<double> into, std::size_t count, std::size_t stride) override {
        for (std::size_t k = 0; k < count; ++k) {
            while (next_ == row_.size())
                read_row();
            into[k * stride] = row_[next_++];
            ++done_;
        }
    }

private:
    void read_row() {
        const std::optional<TextLine> line = lines_.next();
        if (!line || uff58::is_mark(line->text))
            throw refusal(
                {lines_.name(), lines_.number() - 1, 0, ""}, "the time history is cut off",
                "it ends after " + std::to_string(done_) + " of " + std::to_string(dataset_.count) + " values");
        row_ = uff58::values_in(*line, dataset_.ordinate, lines_.name());
        next_ = 0;
    }

    Dataset dataset_;
    LineReader lines_;
    std::vector<double> row_;
    std::size_t next_ = 0;    // of the row
    std::uint64_t done_ = 0;  // of the dataset
};

template <typename Word>
Word reversed(Word word) {
    Word result = 0;
    for (std::size_t byte = 0; byte < sizeof(Word); ++byte)
        result = static_cast<Word>(result << 8U | (word >> (8U * byte) & 0xFFU));
    return result;
}

class BinaryValues final : public Values {
public:
    BinaryValues(const SignalInput& input, const Dataset& dataset)
        : input_(input),
          dataset_(dataset),
          position_(dataset.data_offset) {}

    void read(std::span<double> into, std::size_t count, std::size_t stride) override {
        if (dataset_.ordinate == uff58::real_double)
            read_as<double, std::uint64_t>(into, count, stride);
        else
            read_as<float, std::uint32_t>(into, count, stride);
    }

private:
    template <typename Number, typename Word>
    void read_as(std::span<double> into, std::size_t count, std::size_t stride) {
        block_.resize(count * sizeof(Word));
        if (input_.bytes->read_at(position_, block_) != block_.size())
            throw refusal({input_.name, 0, 0, ""}, "the time history is cut off");
        position_ += block_.size();
        constexpr bool is_little = std::endian::native == std::endian::little;
        const bool is_foreign = (dataset_.form == Form::little_endian) != is_little;
        for (std::size_t k = 0; k < count; ++k) {
            Word word = 0;
            std::memcpy(&word, block_.data() + k * sizeof word, sizeof word);
            into[k * stride] = static_cast<double>(std::bit_cast<Number>(is_foreign ? reversed(word) : word));
        }
    }

    SignalInput input_;
    Dataset dataset_;
    std::uint64_t position_;  // [bytes]
    std::vector<char> block_;
};

class Uff58 final : public signal::Source {
public:
    Uff58(const SignalInput& input, const std::vector<Dataset>& datasets, signal::ChannelLayout layout)
        : layout_(std::move(layout)) {
        for (const Dataset& dataset : datasets)
            if (dataset.form == Form::ascii)
                channels_.push_back(std::make_unique<AsciiValues>(input, dataset));
            else
                channels_.push_back(std::make_unique<BinaryValues>(input, dataset));
    }

    const signal::ChannelLayout& layout() const override { return layout_; }

    std::size_t read(std::span<double> frames) override {
        const std::size_t width = channels_.size();
        STRIDOR_EXPECT(frames.size() % width == 0);
        const auto count =
            static_cast<std::size_t>(std::min<std::uint64_t>(frames.size() / width, *layout_.frames - next_));
        if (count == 0) return 0;
        for (std::size_t channel = 0; channel < width; ++channel)
            channels_[channel]->read(frames.subspan(channel), count, width);
        next_ += count;
        return count;
    }

private:
    signal::ChannelLayout layout_;
    std::vector<std::unique_ptr<Values>> channels_;
    std::uint64_t next_ = 0;
};

bool are_alike(const std::vector<Dataset>& datasets) {
    return std::all_of(datasets.begin(), datasets.end(), [&](const Dataset& dataset) {
        return dataset.count == datasets.front().count && std::abs(dataset.rate / datasets.front().rate - 1.0) < 1e-9;
    });
}

std::string listing(const std::vector<Dataset>& datasets) {
    constexpr std::size_t shown = 8;
    std::string text;
    for (const Dataset& dataset : datasets) {
        if (static_cast<std::size_t>(dataset.number) > shown) return text + ", ...";
        text += (text.empty() ? "" : ", ") + std::to_string(dataset.number) + ": " + std::to_string(dataset.count) +
                " values at " + base::shortest(dataset.rate) + " Hz";
    }
    return text;
}

std::vector<Dataset> chosen(std::vector<Dataset> datasets, std::optional<std::size_t> index, const std::string& file) {
    const base::Place place{file, 0, 0, ""};
    if (index) {
        if (*index < 1 || *index > datasets.size())
            throw refusal(place, "there is no time history " + std::to_string(*index),
                          "the file holds " + std::to_string(datasets.size()));
        return {datasets[*index - 1]};
    }
    if (!are_alike(datasets))
        throw refusal(place, "the time histories differ in rate or length", listing(datasets),
                      "Choose one by its number (--dataset).");
    if (datasets.size() > most_channels)
        throw refusal(place, "the file holds " + std::to_string(datasets.size()) + " time histories",
                      "at most " + std::to_string(most_channels) + " are read at a time",
                      "Choose one by its number (--dataset).");
    return datasets;
}

// ID line 1, which is the same in all channels of some writers; then the label or the point tells them apart
std::vector<std::string> names_of(const std::vector<Dataset>& datasets) {
    std::vector<std::string> names;
    const bool is_shared = datasets.size() > 1 && !datasets.front().id[0].empty() &&
                           std::all_of(datasets.begin(), datasets.end(),
                                       [&](const Dataset& d) { return d.id[0] == datasets.front().id[0]; });
    for (const Dataset& dataset : datasets) {
        const std::string& own = dataset.id[0].empty() ? dataset.label : dataset.id[0];
        const std::string point = dataset.response.empty() ? dataset.label : dataset.response;
        const std::string both = own + " " + point;
        names.emplace_back(is_shared ? base::trimmed(both) : std::string_view(own));
    }
    return names;
}

}  // namespace

bool is_uff(std::string_view beginning) {
    const std::size_t start = beginning.find_first_not_of("\r\n");
    if (start == std::string_view::npos) return false;
    const std::string_view text = beginning.substr(start);
    const std::size_t end = text.find_first_of("\r\n");
    if (end == std::string_view::npos || !uff58::is_mark(text.substr(0, end))) return false;
    const std::string_view rest = base::trimmed(text.substr(end));
    return rest.empty() || (rest.front() >= '0' && rest.front() <= '9') || rest.starts_with("-1");
}

RawSignal open_uff58(const SignalInput& input, std::optional<std::size_t> dataset) {
    uff58::Contents contents = uff58::find_datasets(input);
    if (contents.histories.empty())
        throw refusal(
            {input.name, 0, 0, ""}, "the file holds no time history",
            "it has no dataset 58 of function type 1; " + std::to_string(contents.left_out) + " others were found",
            "Export the time histories; spectra and transfer functions have no sound.");
    const std::vector<Dataset> datasets = chosen(std::move(contents.histories), dataset, input.name);
    const std::vector<std::string> names = names_of(datasets);
    const Dataset& first = datasets.front();
    RawSignal raw;
    raw.format = first.form == Form::ascii ? "UFF 58" : "UFF 58b";
    raw.doubt = Doubt::numbers;
    if (!first.rate_note.empty()) raw.notes.push_back(first.rate_note);
    for (const Dataset& each : datasets)
        if (!each.count_note.empty()) raw.notes.push_back(each.count_note);
    if (contents.left_out > 0)
        raw.left_out.push_back(std::to_string(contents.left_out) + " datasets that are no time histories");
    for (const std::string& each : raw.left_out)
        raw.notes.push_back(each + " were left out");
    for (std::size_t line = 0; line < first.id.size(); ++line)
        if (!first.id[line].empty()) raw.metadata.emplace_back("id" + std::to_string(line + 1), first.id[line]);
    signal::ChannelLayout layout{first.rate, {}, first.count};
    for (std::size_t channel = 0; channel < datasets.size(); ++channel)
        layout.channels.push_back({names[channel], datasets[channel].unit});
    raw.source = std::make_unique<Uff58>(input, datasets, std::move(layout));
    return raw;
}

}  // namespace stridor::recordings
