#include "stridor/classification/verdict.hpp"

#include <limits>
#include <numeric>

namespace stridor::classification {

namespace {

std::size_t sum_of(const Confusion::Row& row) {
    return std::accumulate(row.begin(), row.end(), std::size_t{0});
}

double share(std::size_t part, std::size_t whole) {
    return whole == 0 ? std::numeric_limits<double>::quiet_NaN()
                      : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

Confusion counted(Confusion table, Category truth, Category heard) {
    ++table.counts[static_cast<std::size_t>(truth)][static_cast<std::size_t>(heard)];
    return table;
}

std::size_t total(const Confusion& table) {
    std::size_t sum = 0;
    for (const Confusion::Row& row : table.counts)
        sum += sum_of(row);
    return sum;
}

double agreement(const Confusion& table) {
    std::size_t same = 0;
    for (std::size_t k = 0; k < table.counts.size(); ++k)
        same += table.counts[k][k];
    return share(same, total(table));
}

double agreement_on(const Confusion& table, Category truth) {
    const auto k = static_cast<std::size_t>(truth);
    return share(table.counts[k][k], sum_of(table.counts[k]));
}

Confusion decided(Confusion table) {
    table.counts[static_cast<std::size_t>(Category::undecided)] = {};
    return table;
}

double mean_agreement(const Confusion& table) {
    double total = 0.0;
    double occurring = 0.0;
    for (const Category truth : {Category::none, Category::squeal, Category::squeak, Category::creak}) {
        const double of_it = agreement_on(table, truth);
        if (!(of_it >= 0.0)) continue;  // NaN: it does not occur
        total += of_it;
        occurring += 1.0;
    }
    return total / occurring;
}

Confusion sum(Confusion a, const Confusion& b) {
    for (std::size_t truth = 0; truth < a.counts.size(); ++truth)
        for (std::size_t heard = 0; heard < a.counts.size(); ++heard)
            a.counts[truth][heard] += b.counts[truth][heard];
    return a;
}

}  // namespace stridor::classification
