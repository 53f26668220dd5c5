// Householder's QR decomposition, blocked = Q R: the last columns of Q are the complement (Golub and Van Loan, 5.2).
#include "stridor/model/linear/complement.hpp"

#include <Eigen/QR>

namespace stridor::model {

Eigen::MatrixXd orthogonal_complement(const Eigen::MatrixXd& blocked) {
    const Eigen::HouseholderQR<Eigen::MatrixXd> decomposition(blocked);
    const Eigen::MatrixXd q = decomposition.householderQ();
    return q.rightCols(decomposition.rows() - decomposition.cols());
}

// lazyProduct: each entry is one sum at every size; products in blocks would add large matrices in another order
Eigen::MatrixXd reduced(const Eigen::MatrixXd& left, const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
    const Eigen::MatrixXd half = left.transpose().lazyProduct(matrix);
    return half.lazyProduct(right);
}

}  // namespace stridor::model
