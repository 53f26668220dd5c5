#include "stridor/integration/steps/exchange_tableau.hpp"

#include "stridor/base/check.hpp"

namespace stridor::integration {

ExchangeTableau::ExchangeTableau(const Eigen::MatrixXd& relation, InstructionSet set)
    : kernel_(&row_kernel(set)),
      size_(static_cast<std::size_t>(relation.rows())),
      stride_((size_ + row_lanes - 1) / row_lanes * row_lanes),
      matrix_(size_ * stride_, 0.0),
      follows_(stride_, 0.0),
      is_exchanged_(size_, 0) {
    for (std::size_t j = 0; j < size_; ++j)
        for (std::size_t i = 0; i < size_; ++i)
            matrix_[j * stride_ + i] = relation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
}

void ExchangeTableau::set(const std::vector<double>& b) {
    for (std::size_t i = 0; i < size_; ++i)
        follows_[i] = is_exchanged_[i] != 0 ? 0.0 : b[i];
    for (std::size_t j = 0; j < size_; ++j)
        if (is_exchanged_[j] != 0) kernel_->subtract(&matrix_[j * stride_], b[j], follows_.data(), stride_);
}

void ExchangeTableau::exchange(std::size_t k) {
    double* pivotal = &matrix_[k * stride_];
    const double inverse = 1.0 / pivotal[k];
    for (std::size_t j = 0; j < size_; ++j) {
        if (j == k) continue;
        double* column = &matrix_[j * stride_];
        const double share = column[k] * inverse;
        if (share == 0.0) continue;
        kernel_->subtract(pivotal, share, column, stride_);
        column[k] = -share;
    }
    const double share = follows_[k] * inverse;
    kernel_->subtract(pivotal, share, follows_.data(), stride_);
    follows_[k] = -share;
    for (std::size_t i = 0; i < stride_; ++i)
        pivotal[i] *= inverse;
    pivotal[k] = inverse;
    is_exchanged_[k] = is_exchanged_[k] == 0 ? 1 : 0;
    ++exchanges_;
}

// x_from follows, and so does a share of x_to, whose rest is kept: with m = entry(from, to)
//     x_from = a + m (share x_from + x_to') = (a + m x_to') / (1 - share m)
void ExchangeTableau::shear_kept(std::size_t from, std::size_t to, double share) {
    double* kept = &matrix_[to * stride_];
    const double inverse = 1.0 / (1.0 - share * kept[from]);
    for (std::size_t j = 0; j < size_; ++j) {
        if (j == to) continue;
        double* column = &matrix_[j * stride_];
        const double part = -share * column[from] * inverse;
        if (part != 0.0) kernel_->subtract(kept, part, column, stride_);
    }
    kernel_->subtract(kept, -share * follows_[from] * inverse, follows_.data(), stride_);
    for (std::size_t i = 0; i < stride_; ++i)
        kept[i] *= inverse;
    ++exchanges_;
}

void ExchangeTableau::shear(std::size_t from, std::size_t to, double share) {
    STRIDOR_EXPECT(is_exchanged_[from] != 0 || is_exchanged_[to] == 0);
    if (share == 0.0) return;
    if (is_exchanged_[from] != is_exchanged_[to]) return shear_kept(from, to, share);
    if (is_exchanged_[from] != 0) {
        for (std::size_t j = 0; j < size_; ++j)
            matrix_[j * stride_ + to] -= share * matrix_[j * stride_ + from];
        follows_[to] -= share * follows_[from];
        return;
    }
    for (std::size_t i = 0; i < stride_; ++i)
        matrix_[from * stride_ + i] += share * matrix_[to * stride_ + i];
}

}  // namespace stridor::integration
