#include "stridor/noise_library/sensitivity.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/noise_library/field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace stridor::noise_library {

namespace {

constexpr std::size_t most_value_bins = 10;
constexpr std::size_t usual_bins = 6;
constexpr std::size_t most_counted = 8;       // 8! = 40320 pairings
constexpr std::size_t drawn_pairings = 9999;  // p-values to 0.0001
// two pairings of one coefficient may differ by rounding, not by more
constexpr double same = 1e-12;

// NaN for no values
double median(std::vector<double> values) {
    values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return std::isnan(v); }), values.end());
    if (values.empty()) return unknown;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

// mean ranks less their mean, so that a correlation is a sum of products
std::vector<double> centred_ranks(std::span<const double> values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<double> ranks(values.size());
    const double mean = 0.5 * (static_cast<double>(values.size()) - 1.0);
    for (std::size_t from = 0; from < order.size();) {
        std::size_t to = from + 1;
        while (to < order.size() && values[order[to]] == values[order[from]])
            ++to;
        for (std::size_t k = from; k < to; ++k)
            ranks[order[k]] = 0.5 * static_cast<double>(from + to - 1) - mean;
        from = to;
    }
    return ranks;
}

double product(std::span<const double> a, std::span<const double> b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// SplitMix64 (Steele, Lea, Flood 2014) from a fixed seed: the same p-value every time.
class Draw {
public:
    std::size_t below(std::size_t bound) {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return static_cast<std::size_t>((z ^ (z >> 31U)) % bound);
    }

private:
    std::uint64_t state_ = 1904;
};

double counted_p_value(const std::vector<double>& x, std::vector<double> y, double observed) {
    std::vector<std::size_t> order(y.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::vector<double> values = std::move(y);
    std::size_t all = 0;
    std::size_t as_strong = 0;
    do {
        double sum = 0.0;
        for (std::size_t k = 0; k < x.size(); ++k)
            sum += x[k] * values[order[k]];
        ++all;
        if (std::abs(sum) >= observed) ++as_strong;
    } while (std::next_permutation(order.begin(), order.end()));
    return static_cast<double>(as_strong) / static_cast<double>(all);
}

double drawn_p_value(const std::vector<double>& x, std::vector<double> y, double observed) {
    Draw draw;
    std::size_t as_strong = 0;
    for (std::size_t trial = 0; trial < drawn_pairings; ++trial) {
        for (std::size_t k = y.size() - 1; k > 0; --k)
            std::swap(y[k], y[draw.below(k + 1)]);
        if (std::abs(product(x, y)) >= observed) ++as_strong;
    }
    // the pairing that was observed is one of all
    return static_cast<double>(as_strong + 1) / static_cast<double>(drawn_pairings + 1);
}

Observation observation_of(const Entry& entry, const SensitivityOptions& options) {
    return {entry.id, number_of(entry, options.quantity),
            options.judge == Judge::stridor ? entry.category : entry.denomination, number_of(entry, level_figure),
            number_of(entry, frequency_figure)};
}

std::string unit_of_level(std::span<const Entry> entries) {
    std::set<std::string> units;
    for (const Entry& entry : entries)
        for (const Figure& figure : entry.figures)
            if (figure.name == level_figure) units.insert(figure.unit);
    return units.empty() ? "" : units.size() == 1 ? *units.begin() : "mixed";
}

// those that occur: the five categories in their order, then others by name, then the records without a word
std::vector<std::string> words_in(std::span<const Observation> records) {
    std::set<std::string> found;
    for (const Observation& record : records)
        found.insert(record.category);
    std::vector<std::string> words;
    for (const std::string_view name : classification::category_names)
        if (found.erase(std::string(name)) > 0) words.emplace_back(name);
    const bool has_silent = found.erase("") > 0;
    words.insert(words.end(), found.begin(), found.end());
    if (has_silent) words.emplace_back();
    return words;
}

CategoryRange range_of(const std::string& category, std::span<const Observation> records) {
    std::vector<double> values;
    for (const Observation& record : records)
        if (record.category == category) values.push_back(record.quantity);
    return {category, values.size(), values.front(), median(values), values.back()};
}

Bin bin_of(std::span<const Observation> records, std::span<const CategoryRange> categories) {
    Bin bin{records.front().quantity, records.back().quantity, records.size(), {}, unknown, unknown};
    std::vector<double> levels;
    std::vector<double> frequencies;
    for (const Observation& record : records) {
        levels.push_back(record.level);
        frequencies.push_back(record.frequency);
    }
    for (const CategoryRange& each : categories) {
        const auto count = std::count_if(records.begin(), records.end(),
                                         [&](const Observation& record) { return record.category == each.category; });
        if (count > 0) bin.categories.push_back({each.category, static_cast<std::size_t>(count)});
    }
    bin.level = median(std::move(levels));
    bin.frequency = median(std::move(frequencies));
    return bin;
}

// bins of about equally many records; equal values stay together
std::vector<Bin> bins_of(const Sensitivity& result, std::size_t wanted) {
    const std::span<const Observation> records(result.records);
    std::size_t values = records.empty() ? 0 : 1;
    for (std::size_t k = 1; k < records.size(); ++k)
        values += records[k].quantity != records[k - 1].quantity ? 1 : 0;
    const bool is_by_value = values <= (wanted == 0 ? most_value_bins : wanted);
    const std::size_t count = is_by_value ? records.size() : wanted == 0 ? usual_bins : wanted;
    std::vector<Bin> bins;
    for (std::size_t from = 0; from < records.size();) {
        std::size_t to = from + 1;
        const auto goal = static_cast<std::size_t>(
            std::llround(static_cast<double>((bins.size() + 1) * records.size()) / static_cast<double>(count)));
        while (to < records.size() && (records[to].quantity == records[to - 1].quantity || (!is_by_value && to < goal)))
            ++to;
        bins.push_back(bin_of(records.subspan(from, to - from), result.categories));
        from = to;
    }
    return bins;
}

RankCorrelation over_records(const std::vector<Observation>& records, double Observation::*member) {
    std::vector<double> x;
    std::vector<double> y;
    for (const Observation& record : records) {
        x.push_back(record.quantity);
        y.push_back(record.*member);
    }
    return rank_correlation(x, y);
}

}  // namespace

RankCorrelation rank_correlation(std::span<const double> x, std::span<const double> y) {
    STRIDOR_EXPECT(x.size() == y.size());
    std::vector<double> known_x;
    std::vector<double> known_y;
    for (std::size_t k = 0; k < x.size(); ++k)
        if (!std::isnan(x[k]) && !std::isnan(y[k])) {
            known_x.push_back(x[k]);
            known_y.push_back(y[k]);
        }
    RankCorrelation result;
    result.records = known_x.size();
    if (result.records < 3) return result;
    const std::vector<double> a = centred_ranks(known_x);
    const std::vector<double> b = centred_ranks(known_y);
    const double norm = std::sqrt(product(a, a) * product(b, b));
    if (norm == 0.0) return result;
    const double sum = product(a, b);
    result.coefficient = std::clamp(sum / norm, -1.0, 1.0);
    const double observed = std::abs(sum) - same * norm;
    result.p_value = result.records <= most_counted ? counted_p_value(a, b, observed) : drawn_p_value(a, b, observed);
    return result;
}

Sensitivity sensitivity(std::span<const Entry> entries, const SensitivityOptions& options) {
    Sensitivity result;
    result.quantity = options.quantity;
    result.unit = options.unit;
    result.level_unit = unit_of_level(entries);
    for (const Entry& entry : entries) {
        Observation observation = observation_of(entry, options);
        if (std::isnan(observation.quantity))
            ++result.left_out;
        else
            result.records.push_back(std::move(observation));
    }
    std::sort(result.records.begin(), result.records.end(), [](const Observation& a, const Observation& b) {
        return std::pair(a.quantity, a.id) < std::pair(b.quantity, b.id);
    });
    for (const std::string& word : words_in(result.records))
        result.categories.push_back(range_of(word, result.records));
    result.bins = bins_of(result, options.bins);
    result.level = over_records(result.records, &Observation::level);
    result.frequency = over_records(result.records, &Observation::frequency);
    return result;
}

std::string unit_over(Library& library, const std::string& name) {
    const EntryField* field = find_field(name);
    if (field != nullptr && std::holds_alternative<EntryQuantity>(field->kind)) return std::string(unit_of(*field));
    std::vector<std::string> names =
        field_names([](const EntryField& each) { return std::holds_alternative<EntryQuantity>(each.kind); });
    for (const FigureKind& figure : library.figures()) {
        if (figure.name == name) return figure.unit;
        names.push_back(figure.name);
    }
    throw Error(ErrorKind::input,
                {"--over " + name + " is no quantity",
                 field == nullptr ? "there is no field or figure of that name" : "it is words",
                 base::did_you_mean(name, names, "`stridor library fields` lists them, with units.")});
}

Sensitivity sensitivity_in(Library& library, Query query, SensitivityOptions options) {
    options.unit = unit_over(library, options.quantity);
    query.extent = EntryExtent::figures;
    Sensitivity result = sensitivity(library.find(query), options);
    if (result.records.empty())
        throw Error(ErrorKind::input,
                    {"there are no records over " + options.quantity,
                     result.left_out == 0 ? "no entry meets the conditions"
                                          : fmt::format("it is unknown in all {} of them", result.left_out),
                     "Say it with `stridor library edit ID --" + options.quantity + " VALUE`."});
    return result;
}

}  // namespace stridor::noise_library
