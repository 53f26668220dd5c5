#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace stridor::reduction {

/// The order in which rows are eliminated, so that factors stay sparse; as Eigen's factorisations ask for it.
///
/// Up to `few_rows` approximate minimum degree (Amestoy, Davis and Duff, 1996; Eigen). Beyond, nested dissection
/// (Karypis and Kumar, SIAM Journal on Scientific Computing 20, 1998, 359; METIS), which halves the work for solids and
/// keeps smaller factors. The choice depends on the size alone, so that each machine makes the same.
struct LeastFill {
    using PermutationType = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

    static constexpr Eigen::Index few_rows = 5000;  // [1]

    /// Writes to `order` the old row that becomes each new one, for a matrix with both its triangles. Throws `Error`
    /// (numerical) if METIS fails.
    void operator()(const Eigen::SparseMatrix<double>& matrix, PermutationType& order) const;
};

}  // namespace stridor::reduction
