#pragma once

#include "stridor/classification/category.hpp"

#include <array>
#include <cstddef>

namespace stridor::classification {

/// How often one verdict says what another says.
struct Confusion {
    using Row = std::array<std::size_t, category_names.size()>;
    std::array<Row, category_names.size()> counts{};  // shape [truth][heard], in the order of `category_names`
};

/// The table with one more pair.
Confusion counted(Confusion table, Category truth, Category heard);

/// Pairs in the table.
std::size_t total(const Confusion& table);

/// Share of pairs that agree [1]; NaN for an empty table.
double agreement(const Confusion& table);

/// Share of a truth's pairs that agree [1]; NaN where there are none.
double agreement_on(const Confusion& table, Category truth);

/// The table without the pairs whose truth is undecided: there is nothing to agree with.
Confusion decided(Confusion table);

/// Mean over the decided truths that occur of the share of their pairs that agree [1]: each category weighs the same,
/// however often it occurs. NaN for an empty table.
double mean_agreement(const Confusion& table);

/// Both tables in one.
Confusion sum(Confusion a, const Confusion& b);

}  // namespace stridor::classification
