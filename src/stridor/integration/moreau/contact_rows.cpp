#include "stridor/integration/moreau/contact_rows.hpp"

#include <algorithm>

namespace stridor::integration {

ContactRows::ContactRows(const ModalStructure& structure)
    : rows_(2 * structure.contacts.size()),
      blocks_((structure.modes() + block_modes - 1) / block_modes),
      numbers_(rows_ * blocks_ * block_modes, 0.0),
      partial_(rows_ * block_modes, 0.0) {
    for (std::size_t row = 0; row < rows_; ++row) {
        const ModalContact& contact = structure.contacts[row / 2];
        const std::vector<double>& from = row % 2 == 0 ? contact.normal : contact.tangent;
        for (std::size_t j = 0; j < from.size(); ++j)
            numbers_[(j / block_modes * rows_ + row) * block_modes + j % block_modes] = from[j];
    }
}

void ContactRows::multiply(const std::vector<std::size_t>& which, const std::vector<double>& x,
                           std::vector<double>& products) {
    std::fill(partial_.begin(), partial_.end(), 0.0);
    for (std::size_t block = 0; block < blocks_; ++block) {
        const double* of_block = &numbers_[block * rows_ * block_modes];
        const double* with = &x[block * block_modes];
        for (const std::size_t row : which) {
            const double* numbers = of_block + row * block_modes;
            double* sum = &partial_[row * block_modes];
            for (std::size_t lane = 0; lane < block_modes; ++lane)
                sum[lane] += numbers[lane] * with[lane];
        }
    }
    for (const std::size_t row : which) {
        const double* p = &partial_[row * block_modes];
        products[row] = ((p[0] + p[1]) + (p[2] + p[3])) + ((p[4] + p[5]) + (p[6] + p[7]));
    }
}

void ContactRows::combine(const std::vector<std::size_t>& which, const std::vector<double>& share,
                          std::vector<double>& sum) {
    for (std::size_t block = 0; block < blocks_; ++block) {
        const double* of_block = &numbers_[block * rows_ * block_modes];
        double total[block_modes] = {};
        for (const std::size_t row : which) {
            const double* numbers = of_block + row * block_modes;
            for (std::size_t lane = 0; lane < block_modes; ++lane)
                total[lane] += numbers[lane] * share[row];
        }
        std::copy_n(total, block_modes, &sum[block * block_modes]);
    }
}

}  // namespace stridor::integration
