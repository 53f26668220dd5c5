#include "stridor/integration/steps/exchange_tableau.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stridor::integration {
namespace {

constexpr Eigen::Index size = 11;  // more than one vector, and not a whole number of them

// symmetric and positive definite, with entries of like size
Eigen::MatrixXd relation() {
    Eigen::MatrixXd w(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
        for (Eigen::Index j = 0; j < size; ++j)
            w(i, j) = std::cos(static_cast<double>(3 * (i + j) + i * j)) + (i == j ? 12.0 : 0.0);
    return w;
}

std::vector<double> constants() {
    std::vector<double> b;
    for (Eigen::Index i = 0; i < size; ++i)
        b.push_back(std::sin(static_cast<double>(i + 1)));
    return b;
}

// x of the exchanged, so that their y is 0
Eigen::VectorXd solved(const Eigen::MatrixXd& w, const std::vector<double>& b, const std::vector<Eigen::Index>& which) {
    const Eigen::MatrixXd part = w(which, which);
    Eigen::VectorXd wanted(part.rows());
    for (Eigen::Index r = 0; r < part.rows(); ++r)
        wanted(r) = -b[static_cast<std::size_t>(which[static_cast<std::size_t>(r)])];
    Eigen::VectorXd x = Eigen::VectorXd::Zero(size);
    const Eigen::VectorXd solution = part.partialPivLu().solve(wanted);
    x(which) = solution;
    return x;
}

void expect_solution(const ExchangeTableau& tableau, const std::vector<Eigen::Index>& which) {
    const Eigen::VectorXd x = solved(relation(), constants(), which);
    const Eigen::VectorXd y = relation() * x + Eigen::Map<const Eigen::VectorXd>(constants().data(), size);
    for (std::size_t k = 0; k < tableau.size(); ++k)
        EXPECT_NEAR(tableau.follows(k),
                    tableau.is_exchanged(k) ? x(static_cast<Eigen::Index>(k)) : y(static_cast<Eigen::Index>(k)), 1e-13);
}

TEST(ExchangeTableau, SolvesForWhatIsExchanged) {
    ExchangeTableau tableau(relation());
    for (const std::size_t k : {7U, 0U, 3U, 10U})
        tableau.exchange(k);
    tableau.set(constants());
    expect_solution(tableau, {0, 3, 7, 10});
}

TEST(ExchangeTableau, FollowsWhileItIsExchanged) {
    ExchangeTableau tableau(relation());
    tableau.set(constants());
    for (const std::size_t k : {2U, 5U, 9U, 5U})  // 5 goes and comes back
        tableau.exchange(k);
    expect_solution(tableau, {2, 9});
    EXPECT_EQ(tableau.exchanges(), 4);
}

// x1 = share x0 + what follows: the solution is that of a sheared relation
TEST(ExchangeTableau, ShearsBothWays) {
    Eigen::MatrixXd sheared = relation();
    sheared.col(0) += 0.3 * sheared.col(1);
    ExchangeTableau wanted(sheared);
    wanted.exchange(0);
    wanted.set(constants());

    ExchangeTableau before(relation());
    before.shear(0, 1, 0.3);
    before.exchange(0);
    before.set(constants());

    ExchangeTableau while_exchanged(relation());
    while_exchanged.set(constants());
    while_exchanged.exchange(0);
    while_exchanged.exchange(1);
    while_exchanged.shear(0, 1, 0.3);
    while_exchanged.exchange(1);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        EXPECT_NEAR(before.follows(k), wanted.follows(k), 1e-14);
        EXPECT_NEAR(while_exchanged.follows(k), wanted.follows(k), 1e-14);
    }
}

// x0 follows, x1 is kept and has a share of it: as if sheared before
TEST(ExchangeTableau, ShearsWhatIsKeptByWhatFollows) {
    Eigen::MatrixXd sheared = relation();
    sheared.col(0) += 0.3 * sheared.col(1);
    ExchangeTableau wanted(sheared);
    wanted.set(constants());
    wanted.exchange(0);

    ExchangeTableau tableau(relation());
    tableau.set(constants());
    tableau.exchange(0);
    tableau.shear(0, 1, -0.2);
    tableau.shear(0, 1, 0.5);
    for (std::size_t k = 0; k < wanted.size(); ++k)
        EXPECT_NEAR(tableau.follows(k), wanted.follows(k), 1e-13);
    for (std::size_t row = 0; row < wanted.size(); ++row)
        for (std::size_t column = 0; column < wanted.size(); ++column)
            EXPECT_NEAR(tableau.entry(row, column), wanted.entry(row, column), 1e-13);
}

TEST(ExchangeTableau, StaysExactOverManyExchanges) {
    ExchangeTableau tableau(relation());
    for (std::size_t n = 0; n < 220; ++n)
        tableau.exchange(n * 7 % static_cast<std::size_t>(size));  // each 20 times: all as they were
    tableau.exchange(4);
    tableau.set(constants());
    expect_solution(tableau, {4});
}

}  // namespace
}  // namespace stridor::integration
