#include "stridor/reduction/least_fill.hpp"

#include "stridor/base/error.hpp"

#include <Eigen/OrderingMethods>
#include <fmt/format.h>
#include <metis.h>

#include <mutex>
#include <type_traits>
#include <vector>

namespace stridor::reduction {

namespace {

static_assert(std::is_same_v<idx_t, int>);

/// Which rows meet which others, themselves left out.
struct Neighbours {
    std::vector<int> begin;  // shape [row + 1]
    std::vector<int> rows;
};

Neighbours neighbours_in(const Eigen::SparseMatrix<double>& matrix) {
    Neighbours found{{0}, {}};
    found.begin.reserve(static_cast<std::size_t>(matrix.cols()) + 1);
    found.rows.reserve(static_cast<std::size_t>(matrix.nonZeros()));
    for (Eigen::Index column = 0; column < matrix.outerSize(); ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry)
            if (entry.row() != column) found.rows.push_back(static_cast<int>(entry.row()));
        found.begin.push_back(static_cast<int>(found.rows.size()));
    }
    return found;
}

}  // namespace

void LeastFill::operator()(const Eigen::SparseMatrix<double>& matrix, PermutationType& order) const {
    if (matrix.cols() <= few_rows) {
        Eigen::AMDOrdering<int>()(matrix, order);
        return;
    }
    Neighbours neighbours = neighbours_in(matrix);
    int rows = static_cast<int>(matrix.cols());
    order.resize(rows);
    std::vector<int> place(static_cast<std::size_t>(rows));
    // with its own options: among them the seed of its choices
    static std::mutex one_at_a_time;  // METIS' choices come from the C library's rand, one for the process
    const std::scoped_lock alone(one_at_a_time);
    const int end = METIS_NodeND(&rows, neighbours.begin.data(), neighbours.rows.data(), nullptr, nullptr,
                                 order.indices().data(), place.data());
    if (end != METIS_OK)
        throw Error(ErrorKind::numerical, {"the rows of the part could not be ordered",
                                           fmt::format("METIS ended with {}: no memory, or a signal", end), ""});
}

}  // namespace stridor::reduction
