#include "stridor/recordings/uff58/uff58_header.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/calibration.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/csv_table.hpp"
#include "stridor/recordings/time_grid.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <tuple>
#include <utility>

namespace stridor::recordings::uff58 {

namespace {

constexpr std::size_t header_lines = 11;
constexpr std::size_t most_histories = 4096;
constexpr double highest_rate = 1e9;  // [Hz]

using Cards = std::array<std::string, header_lines>;

/// What the line of the dataset's number says.
struct Opening {
    bool is_58 = false;
    Form form = Form::ascii;
    std::optional<std::uint64_t> bytes;  // [bytes] of binary values, where it says so
};

std::optional<long long> whole(std::string_view text) {
    text = base::trimmed(text);
    long long number = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_whole = code == std::errc{} && end == text.data() + text.size();
    return is_whole ? std::optional(number) : std::nullopt;
}

std::string_view columns(std::string_view line, std::size_t from, std::size_t length) {
    return from < line.size() ? line.substr(from, length) : std::string_view();
}

// the fields of a card by its columns; by its words where the columns were not kept
std::vector<std::string_view> fields_of(std::string_view card, const std::vector<std::size_t>& widths) {
    std::vector<std::string_view> by_words = words(card);
    if (by_words.size() == widths.size()) return by_words;  // how wide they are does not matter then
    std::vector<std::string_view> fields;
    std::size_t from = 0;
    for (const std::size_t width : widths) {
        fields.push_back(base::trimmed(columns(card, from, width)));
        from += width;
    }
    return fields;
}

std::string meaningful(std::string_view text) {
    const std::string found(base::trimmed(text));
    return csv_table::lower(found) == "none" ? "" : found;
}

Opening opening_of(const TextLine& line, const std::string& file) {
    const std::vector<std::string_view> fields = words(line.text);
    Opening opening;
    if (fields.empty()) return opening;
    opening.is_58 = fields[0] == "58" || fields[0] == "58b" || fields[0] == "58B";
    if (!opening.is_58 || fields[0] == "58") {
        // "58 b": some write the letter apart
        const bool is_apart = opening.is_58 && fields.size() > 1 && (fields[1] == "b" || fields[1] == "B");
        if (!is_apart) return opening;
    }
    const std::size_t first = fields[0] == "58" ? 2 : 1;
    const auto number = [&](std::size_t k) {
        return first + k < fields.size() ? whole(fields[first + k]) : std::nullopt;
    };
    const base::Place place = place_of(file, line, 1);
    if (number(0) != 1 && number(0) != 2)
        throw refusal(place, "dataset 58b has an unknown byte order",
                      "1 (little endian) or 2 (big endian) is expected");
    opening.form = number(0) == 1 ? Form::little_endian : Form::big_endian;
    if (number(1).value_or(2) != 2)
        throw refusal(place, "dataset 58b has numbers of VMS or IBM format", "IEEE 754 (2) is read");
    if (const auto bytes = number(3); bytes && *bytes > 0) opening.bytes = static_cast<std::uint64_t>(*bytes);
    return opening;
}

// "Acceleration         m/s^2", the two labels of records 8 to 11
std::pair<std::string, std::string> labels_of(std::string_view card) {
    constexpr std::size_t numbers_width = 25;
    constexpr std::size_t label_width = 21;  // with the blank before it
    bool has_columns = true;
    for (const auto& [from, length] : {std::pair<std::size_t, std::size_t>{0, 10}, {10, 5}, {15, 5}, {20, 5}})
        has_columns = has_columns && whole(columns(card, from, length)).has_value();
    std::string_view rest = columns(card, numbers_width, card.size());
    if (!has_columns) {
        const std::vector<std::string_view> parts = words(card);
        if (parts.size() < 5) return {};
        rest = card.substr(static_cast<std::size_t>(parts[4].data() - card.data()));
    }
    const bool is_cut = rest.size() > label_width && rest[label_width - 1] != ' ' && rest[label_width] != ' ';
    if (has_columns && !is_cut)
        return {meaningful(columns(rest, 0, label_width)), meaningful(columns(rest, label_width, label_width))};
    // the columns were not kept: two blanks part the labels, or the last word is the unit
    const std::string_view text = base::trimmed(rest);
    std::size_t gap = text.find("  ");
    if (gap == std::string_view::npos) gap = text.rfind(' ');
    if (gap == std::string_view::npos) return {meaningful(text), ""};
    return {meaningful(text.substr(0, gap)), meaningful(text.substr(gap))};
}

// "rate: 48000 Hz" in one of the five lines of free text
std::optional<double> written_rate(const std::array<std::string, 5>& id) {
    for (const std::string& line : id) {
        const std::size_t at = csv_table::lower(line).find("rate:");
        if (at == std::string::npos) continue;
        const std::vector<std::string_view> parts = words(std::string_view(line).substr(at + 5));
        if (parts.size() < 2 || csv_table::lower(parts[1]) != "hz") continue;
        const std::optional<double> rate = fortran_number(parts[0]);
        if (rate && std::isfinite(*rate) && *rate > 0.0) return rate;
    }
    return std::nullopt;
}

// what one of the abscissa is in seconds; nothing said means seconds
double unit_of_time(const std::string& label, const base::Place& place) {
    if (label.empty()) return 1.0;
    for (const std::string& spelling : {label, csv_table::lower(label)})  // "S" is no siemens here
        if (const FullScale unit = unit_of_label(spelling); unit.unit == "s") return unit.value;
    throw refusal(place, "the time is in \"" + label + "\"", "that is no unit of time that is known",
                  "Write s, ms or us into the label of the abscissa (record 8).");
}

SnappedRate rate_of(std::string_view step_numeral, double unit, const std::array<std::string, 5>& id,
                    const base::Place& place) {
    std::optional<double> step = fortran_number(step_numeral);
    if (step) *step *= unit;
    const bool is_step = step && *step >= 1.0 / highest_rate && std::isfinite(*step) && *step <= 1e9;
    if (!is_step)
        throw refusal(place, "the time step \"" + std::string(step_numeral) + "\" is no step", "it must be positive",
                      "Write the step into columns 44 to 56 of this line (record 7).");
    const std::optional<double> written = written_rate(id);
    // an ID line that is meant for other data does not agree with the step
    if (written && std::abs(*written * *step - 1.0) <= 6e-6) return {*written};
    return snapped_rate(*step, step_tolerance(step_numeral));
}

Dataset read_header(const Cards& cards, Form form, const LineReader& lines) {
    const base::Place place{lines.name(), lines.number() - 5, 0, cards[6]};
    Dataset dataset;
    dataset.form = form;
    std::copy_n(cards.begin(), dataset.id.size(), dataset.id.begin());
    for (std::string& line : dataset.id)
        line = meaningful(line);
    const std::vector<std::string_view> data = fields_of(cards[6], {10, 10, 10, 13, 13, 13});
    const auto ordinate = whole(data[0]);
    const auto count = whole(data[1]);
    const auto spacing = whole(data[2]);
    if (!ordinate || !count || !spacing)
        throw refusal(place, "the form of the data cannot be read", "record 7 of dataset 58 holds three whole numbers");
    if (*spacing == 0)
        throw refusal(place, "the time history has an uneven step", "only even ones are read", "Resample it first.");
    if (*ordinate != real_single && *ordinate != real_double)
        throw refusal(place, "the time history holds data of type " + std::string(data[0]),
                      "real numbers (2 or 4) are read", "Export the time history; a spectrum has no sound.");
    if (*count <= 0) throw refusal(place, "the time history holds no values");
    dataset.ordinate = static_cast<int>(*ordinate);
    dataset.count = static_cast<std::uint64_t>(*count);
    const double unit = unit_of_time(labels_of(cards[7]).second, {lines.name(), lines.number() - 4, 0, cards[7]});
    dataset.start = fortran_number(data[3]).value_or(0.0) * unit;
    const SnappedRate rate = rate_of(data[4], unit, dataset.id, place);
    dataset.rate = rate.rate;
    dataset.rate_note = rate.note;
    std::tie(dataset.label, dataset.unit) = labels_of(cards[8]);
    const std::vector<std::string_view> response = words(columns(cards[5], 31, 24));
    if (response.size() == 2) dataset.response = std::string(response[0]) + ":" + std::string(response[1]);
    dataset.data_offset = lines.offset();
    dataset.data_line = lines.number();
    return dataset;
}

// type of the function and of its abscissa: is it one over time?
bool is_history(const Cards& cards) {
    const std::vector<std::string_view> function = words(cards[5]);
    const std::vector<std::string_view> abscissa = words(cards[7]);
    std::optional<long long> type = function.empty() ? std::nullopt : whole(function[0]);
    if (!type || *type > 99999) type = whole(columns(cards[5], 0, 5));
    const std::optional<long long> axis = abscissa.empty() ? std::nullopt : whole(abscissa[0]);
    return type == time_response || (type == general_function && axis == time_abscissa);
}

bool has_mark_at(const SignalInput& input, std::uint64_t offset) {
    const std::string text = text_at(*input.bytes, offset, 16);
    const std::string_view content = base::trimmed(text);
    return content.starts_with("-1") || (offset >= input.bytes->size() && content.empty());
}

// the next mark behind binary values, as all writers print it
std::optional<std::uint64_t> mark_behind(const SignalInput& input, std::uint64_t from) {
    constexpr std::string_view mark = "    -1";
    constexpr std::size_t block = 1U << 20U;  // [bytes]
    for (std::uint64_t at = from; at < input.bytes->size(); at += block) {
        const std::string text = text_at(*input.bytes, at, block + mark.size());
        for (std::size_t k = text.find(mark); k < block; k = text.find(mark, k + 1)) {
            const char next = k + mark.size() < text.size() ? text[k + mark.size()] : '\n';
            if (next == '\n' || next == '\r') return at + k;
        }
    }
    return std::nullopt;
}

bool has_only_zeros(const SignalInput& input, std::uint64_t from, std::uint64_t end) {
    constexpr std::uint64_t most = 1U << 16U;  // [bytes] more is no filling
    const std::string text =
        end - from > most ? "x" : text_at(*input.bytes, from, static_cast<std::size_t>(end - from));
    return text.find_first_not_of('\0') == std::string::npos;
}

// the values that stand there count, whatever the header says
void correct_count(Dataset& dataset, std::uint64_t there, const std::string& file) {
    if (there == 0) throw refusal({file, dataset.data_line, 0, ""}, "the time history holds no values");
    dataset.count_note = "time history " + std::to_string(dataset.number) + ": the header speaks of " +
                         std::to_string(dataset.count) + " values, the " + std::to_string(there) +
                         " that are there were read";
    dataset.count = there;
}

std::uint64_t width_of(int ordinate) {
    return ordinate == real_double ? 8 : 4;
}

// Where the values of a binary dataset end; `claimed` is the number of bytes that its first line gives. A mark decides
// where that and the number of values differ.
std::uint64_t settle_binary_end(const SignalInput& input, Dataset& dataset, std::optional<std::uint64_t> claimed) {
    const std::uint64_t begin = dataset.data_offset;
    const std::uint64_t left = input.bytes->size() - begin;
    const std::uint64_t width = width_of(dataset.ordinate);
    const bool fits = dataset.count <= left / width;
    const std::uint64_t needed = fits ? dataset.count * width : 0;
    if (fits && claimed == needed) return begin + needed;
    const bool is_claim_marked = claimed && *claimed <= left && has_mark_at(input, begin + *claimed);
    if (fits && !is_claim_marked && has_mark_at(input, begin + needed)) return begin + needed;
    const std::optional<std::uint64_t> mark = is_claim_marked ? begin + *claimed : mark_behind(input, begin);
    if (!mark)
        throw refusal({input.name, dataset.data_line, 0, ""},
                      fits ? "where the time history ends is not known" : "the time history is cut off",
                      "its header speaks of " + std::to_string(dataset.count) + " values, there is room for " +
                          std::to_string(left / width) + ", and no mark (-1) ends them");
    const std::uint64_t there = (*mark - begin) / width;  // a line end may stand before the mark
    const bool is_filled = there > dataset.count && has_only_zeros(input, begin + needed, begin + there * width);
    if (there != dataset.count && !is_filled) correct_count(dataset, there, input.name);
    return *mark;
}

/// Goes through a file from mark to mark.
class Walk {
public:
    explicit Walk(const SignalInput& input) : input_(input), lines_(input.bytes, input.name) {}

    Contents contents() && {
        while (find_mark()) {
            const std::optional<TextLine> line = lines_.next();
            if (!line) break;
            // two marks in a row: the first one ended what had no beginning
            if (is_mark(line->text)) {
                const std::optional<TextLine> next = lines_.next();
                if (!next) break;
                read_block(opening_of(*next, input_.name));
                continue;
            }
            read_block(opening_of(*line, input_.name));
        }
        return std::move(contents_);
    }

private:
    bool find_mark() {
        while (const auto line = lines_.next())
            if (is_mark(line->text)) return true;
        return false;
    }

    void read_block(const Opening& opening) {
        if (!opening.is_58) {
            ++contents_.left_out;
            find_mark();
            return;
        }
        Cards cards;
        for (std::string& card : cards) {
            const std::optional<TextLine> line = lines_.next();
            if (!line || is_mark(line->text))
                throw refusal({input_.name, lines_.number() - 1, 0, ""}, "the header of dataset 58 is cut off",
                              "it has 11 lines");
            card = std::string(line->text.substr(0, 1000));
        }
        const bool is_wanted = is_history(cards);
        if (!is_wanted) ++contents_.left_out;
        if (opening.form == Form::ascii && !is_wanted) {
            find_mark();
            return;
        }
        if (!is_wanted) return skip_binary(opening);
        take(read_header(cards, opening.form, lines_), opening);
    }

    // a binary function that is not over time: its values may look like anything
    void skip_binary(const Opening& opening) {
        const std::uint64_t left = input_.bytes->size() - lines_.offset();
        const std::uint64_t length = std::min(opening.bytes.value_or(0), left);
        lines_ = LineReader(input_.bytes, input_.name, lines_.offset() + length, lines_.number());
        find_mark();
    }

    void take(Dataset dataset, const Opening& opening) {
        if (contents_.histories.size() >= most_histories)
            throw refusal({input_.name, dataset.data_line, 0, ""},
                          "the file holds more than " + std::to_string(most_histories) + " time histories");
        dataset.number = static_cast<int>(contents_.histories.size()) + 1;
        if (dataset.form == Form::ascii) {
            count_values(dataset);
        } else {
            const std::uint64_t end = settle_binary_end(input_, dataset, opening.bytes);
            lines_ = LineReader(input_.bytes, input_.name, end, lines_.number());
            find_mark();
        }
        contents_.histories.push_back(std::move(dataset));
    }

    // up to the mark; zeros that fill the last line are no values
    void count_values(Dataset& dataset) {
        std::uint64_t there = 0;
        std::uint64_t last_value = 0;  // the last that is not zero
        std::size_t in_line = 0;
        bool is_ended = false;
        while (const auto line = lines_.next()) {
            is_ended = is_mark(line->text);
            if (is_ended) break;
            std::vector<double> values;
            try {
                values = values_in(*line, dataset.ordinate, input_.name);
            } catch (const Error&) {
                find_mark();
                return;  // it comes again, should somebody read this history
            }
            for (std::size_t k = 0; k < values.size(); ++k)
                if (values[k] != 0.0) last_value = there + k + 1;
            there += values.size();
            if (!values.empty()) in_line = values.size();
        }
        const bool is_filled = last_value <= dataset.count && there - std::min(there, dataset.count) < in_line;
        if (there < dataset.count && !is_ended)
            throw refusal({input_.name, lines_.number() - 1, 0, ""}, "the time history is cut off",
                          "it ends after " + std::to_string(there) + " of " + std::to_string(dataset.count) +
                              " values, without a mark (-1)");
        if (there < dataset.count || (there > dataset.count && !is_filled)) correct_count(dataset, there, input_.name);
    }

    SignalInput input_;
    LineReader lines_;
    Contents contents_;
};

}  // namespace

bool is_mark(std::string_view line) {
    if (line.starts_with(csv_table::utf8_mark)) line.remove_prefix(csv_table::utf8_mark.size());
    // a value of -1 stands further right
    return base::trimmed(line) == "-1" && line.find("-1") <= 4;
}

std::vector<double> values_in(const TextLine& line, int ordinate, const std::string& file) {
    std::vector<double> values;
    bool is_parted = true;
    for (const std::string_view word : words(line.text)) {
        const std::optional<double> number = fortran_number(word);
        is_parted = is_parted && number;
        values.push_back(number.value_or(0.0));
    }
    if (is_parted) return values;
    values.clear();
    const std::size_t width = ordinate == real_double ? 20 : 13;
    const std::string_view text = line.text.substr(0, line.text.find_last_not_of(" \t\r") + 1);
    for (std::size_t from = 0; from < text.size(); from += width) {
        const std::string_view field = base::trimmed(text.substr(from, width));
        const std::optional<double> number = fortran_number(field);
        if (!number)
            throw refusal(place_of(file, line, static_cast<int>(from) + 1),
                          "\"" + std::string(field) + "\" is not a number");
        values.push_back(*number);
    }
    return values;
}

Contents find_datasets(const SignalInput& input) {
    return Walk(input).contents();
}

}  // namespace stridor::recordings::uff58
