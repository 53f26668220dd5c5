#include "stridor/model/linear/complement.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace stridor::model {
namespace {

// [size, columns] of small whole numbers, whose columns a diagonal keeps apart
Eigen::MatrixXd directions(Eigen::Index size, Eigen::Index columns) {
    Eigen::MatrixXd matrix(size, columns);
    for (Eigen::Index j = 0; j < columns; ++j)
        for (Eigen::Index i = 0; i < size; ++i)
            matrix(i, j) = *rc::gen::inRange(-9, 10) + (i == j ? 100.0 : 0.0);
    return matrix;
}

RC_GTEST_PROP(OrthogonalComplement, IsOrthonormalAndOrthogonalToWhatIsBlocked, ()) {
    const auto size = *rc::gen::inRange<Eigen::Index>(1, 8);
    const auto columns = *rc::gen::inRange<Eigen::Index>(0, size + 1);
    const Eigen::MatrixXd blocked = directions(size, columns);
    const Eigen::MatrixXd free = orthogonal_complement(blocked);
    RC_ASSERT(free.rows() == size);
    RC_ASSERT(free.cols() == size - columns);
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(free.cols(), free.cols());
    RC_ASSERT((free.transpose() * free - identity).cwiseAbs().sum() < 1e-13);
    RC_ASSERT((free.transpose() * blocked).cwiseAbs().sum() < 1e-11);
}

TEST(OrthogonalComplement, IsEverythingWhereNothingIsBlocked) {
    EXPECT_EQ(orthogonal_complement(Eigen::MatrixXd(3, 0)), Eigen::MatrixXd::Identity(3, 3));
}

}  // namespace
}  // namespace stridor::model
