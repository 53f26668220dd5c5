// The order of elimination without METIS, which is for parts larger than a page computes.

#include "stridor/reduction/least_fill.hpp"

#include "stridor/base/error.hpp"

#include <Eigen/OrderingMethods>

namespace stridor::reduction {

void LeastFill::operator()(const Eigen::SparseMatrix<double>& matrix, PermutationType& order) const {
    if (matrix.cols() > few_rows)
        throw Error(ErrorKind::input, {"the part has more rows than the page in one file solves", "5000 are the most",
                                       "Open this case with stridor explore."});
    Eigen::AMDOrdering<int>()(matrix, order);
}

}  // namespace stridor::reduction
