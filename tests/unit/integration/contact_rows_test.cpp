#include "stridor/integration/steps/contact_rows.hpp"

#include "stridor/integration/steps/exchange_tableau.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stridor::integration {
namespace {

constexpr std::size_t contacts = 7;

// more modes than four blocks of eight, and not a whole number of them
ModalStructure rows_of_numbers(std::size_t modes) {
    ModalStructure structure;
    structure.square_frequency.assign(modes, 1.0);
    for (std::size_t k = 0; k < contacts; ++k) {
        ModalContact contact;
        for (std::size_t j = 0; j < modes; ++j) {
            contact.normal.push_back(std::sin(static_cast<double>(1 + j + 17 * k)));
            contact.tangent.push_back(std::cos(static_cast<double>(2 + 3 * j + 5 * k)));
        }
        structure.contacts.push_back(contact);
    }
    return structure;
}

const std::vector<std::size_t> some_rows{0, 3, 4, 5, 11, 13};

TEST(ContactRows, MultiplyAndCombineTheRowsThatAreAskedFor) {
    for (const std::size_t modes : {1U, 8U, 53U}) {
        const ModalStructure structure = rows_of_numbers(modes);
        ContactRows rows(structure);
        std::vector<double> x(rows.padded_modes(), 0.0), products(2 * contacts, -9.0), share(2 * contacts, 0.0);
        for (std::size_t j = 0; j < modes; ++j)
            x[j] = std::sin(0.3 + static_cast<double>(j));
        rows.multiply(some_rows, x, products);
        EXPECT_EQ(products[1], -9.0);
        EXPECT_NEAR(products[4], dot(structure.contacts[2].normal, {x.data(), modes}), 1e-13);
        EXPECT_NEAR(products[13], dot(structure.contacts[6].tangent, {x.data(), modes}), 1e-13);
        share[4] = 2.0;
        share[13] = -3.0;
        share[1] = 100.0;  // not asked for
        std::vector<double> sum(rows.padded_modes(), 7.0);
        rows.combine(some_rows, share, sum);
        for (std::size_t j = 0; j < modes; ++j)
            EXPECT_NEAR(sum[j], 2.0 * structure.contacts[2].normal[j] - 3.0 * structure.contacts[6].tangent[j], 1e-14);
    }
}

// many contacts keep their bits on any machine
TEST(ContactRows, HaveTheSameBitsForEveryInstructionSet) {
    const ModalStructure structure = rows_of_numbers(53);
    std::vector<double> wanted_products, wanted_sum, wanted_solution;
    for (const InstructionSet set : available_instruction_sets()) {
        ContactRows rows(structure, set);
        std::vector<double> x(rows.padded_modes(), 0.0), products(2 * contacts, 0.0), sum(rows.padded_modes(), 0.0);
        for (std::size_t j = 0; j < 53; ++j)
            x[j] = std::cos(0.7 * static_cast<double>(j));
        rows.multiply(some_rows, x, products);
        rows.combine(some_rows, products, sum);
        Eigen::MatrixXd relation(2 * contacts, 2 * contacts);
        for (Eigen::Index i = 0; i < relation.rows(); ++i)
            for (Eigen::Index j = 0; j < relation.cols(); ++j)
                relation(i, j) = std::sin(static_cast<double>(i * j + 1)) + (i == j ? 20.0 : 0.0);
        ExchangeTableau tableau(relation, set);
        for (const std::size_t row : some_rows)
            tableau.exchange(row);
        tableau.set(products);
        std::vector<double> solution;
        for (std::size_t k = 0; k < tableau.size(); ++k)
            solution.push_back(tableau.follows(k));
        if (set == InstructionSet::baseline) {
            wanted_products = products;
            wanted_sum = sum;
            wanted_solution = solution;
        }
        EXPECT_EQ(products, wanted_products);
        EXPECT_EQ(sum, wanted_sum);
        EXPECT_EQ(solution, wanted_solution);
    }
}

}  // namespace
}  // namespace stridor::integration
