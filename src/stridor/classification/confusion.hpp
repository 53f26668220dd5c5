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

}  // namespace stridor::classification
