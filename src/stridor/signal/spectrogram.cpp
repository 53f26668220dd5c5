#include "stridor/signal/spectrogram.hpp"

#include <algorithm>

namespace stridor::signal {

Spectrograph::Spectrograph(double spacing, double hop, std::size_t lines, SpectrogramBounds bounds)
    : spacing_(spacing),
      hop_(hop),
      most_columns_(bounds.columns),
      pool_((lines + bounds.rows - 1) / bounds.rows),
      rows_(lines / pool_),
      current_(rows_) {}

void Spectrograph::push(std::span<const double> density) {
    for (std::size_t row = 0; row < rows_; ++row) {
        double sum = 0.0;
        for (std::size_t k = row * pool_; k < (row + 1) * pool_; ++k)
            sum += density[k];
        current_[row] += sum / static_cast<double>(pool_);
    }
    if (++filled_ < stride_) return;
    for (double& value : current_) {
        density_.push_back(value / static_cast<double>(stride_));
        value = 0.0;
    }
    filled_ = 0;
    if (density_.size() == most_columns_ * rows_) merge();
}

void Spectrograph::merge() {
    for (std::size_t column = 0; 2 * column < most_columns_; ++column)
        for (std::size_t row = 0; row < rows_; ++row)
            density_[column * rows_ + row] =
                0.5 * (density_[2 * column * rows_ + row] + density_[(2 * column + 1) * rows_ + row]);
    density_.resize(most_columns_ / 2 * rows_);
    stride_ *= 2;
}

Spectrogram Spectrograph::spectrogram() const {
    Spectrogram result;
    result.column = hop_ * static_cast<double>(stride_);
    result.row = spacing_ * static_cast<double>(pool_);
    result.rows = rows_;
    // a frame of two hops has its middle a hop after its beginning, and stands for half a hop around it
    result.from = 0.5 * hop_;
    result.density = density_;
    // what stands in a column that is not full yet counts too, if it is most of one
    if (2 * filled_ > stride_)
        for (const double value : current_)
            result.density.push_back(value / static_cast<double>(filled_));
    return result;
}

Spectrogram spectrogram(const Signal& signal, std::size_t size) {
    Spectrograph graph(signal.rate / static_cast<double>(size), 0.5 * static_cast<double>(size) / signal.rate,
                       size / 2 + 1);
    Welch average(signal.rate, {size, Window::hann}, [&](std::span<const double> density) { graph.push(density); });
    average.push(signal.samples);
    static_cast<void>(average.spectrum());
    Spectrogram result = graph.spectrogram();
    result.unit = signal.unit;
    return result;
}

}  // namespace stridor::signal
