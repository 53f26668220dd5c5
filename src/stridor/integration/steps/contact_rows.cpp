#include "stridor/integration/steps/contact_rows.hpp"

namespace stridor::integration {

ContactRows::ContactRows(const ModalStructure& structure, InstructionSet set)
    : kernel_(&row_kernel(set)),
      plan_(row_plan(structure.contacts)),
      rows_(plan_.rows()),
      blocks_((structure.modes() + row_lanes - 1) / row_lanes),
      numbers_(rows_ * blocks_ * row_lanes, 0.0),
      partial_(rows_ * row_lanes, 0.0) {
    for (std::size_t row = 0; row < rows_; ++row) {
        const std::span<const double> from = row_of(structure.contacts, plan_, row);
        for (std::size_t j = 0; j < from.size(); ++j)
            numbers_[(j / row_lanes * rows_ + row) * row_lanes + j % row_lanes] = from[j];
    }
}

void ContactRows::multiply(const std::vector<std::size_t>& which, const std::vector<double>& x,
                           std::vector<double>& products) {
    kernel_->multiply(blocks_of(which), x.data(), partial_.data());
    for (const std::size_t row : which) {
        const double* p = &partial_[row * row_lanes];
        products[row] = ((p[0] + p[1]) + (p[2] + p[3])) + ((p[4] + p[5]) + (p[6] + p[7]));
    }
}

void ContactRows::combine(const std::vector<std::size_t>& which, const std::vector<double>& share,
                          std::vector<double>& sum) {
    kernel_->combine(blocks_of(which), share.data(), sum.data());
}

}  // namespace stridor::integration
