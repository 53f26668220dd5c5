#pragma once

#include "stridor/signal/source.hpp"
#include "stridor/signal/spectrum.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace stridor::signal {

/// Power over time and frequency: columns of equal duration, rows of equal width.
struct Spectrogram {
    double column = 0.0;  // [s] duration of a column; the first one begins at `from`
    double row = 0.0;     // [Hz] width of a row; row r lies around (r + 1/2) * row
    std::size_t rows = 0;
    std::string unit = full_scale;  // of the samples
    std::vector<double> density{};  // [unit²/Hz] shape [column][row]
    double from = 0.0;              // [s] start; a column lies around the middles of its frames
    /// Returns the number of columns [1].
    std::size_t columns() const { return rows == 0 ? 0 : density.size() / rows; }
};

/// The largest size of a spectrogram.
struct SpectrogramBounds {
    std::size_t rows = 512;
    std::size_t columns = 1024;  // even
};

/// Collects the frames of a `Welch` in a spectrogram of bounded size. Lines are averaged into at most `bounds.rows`
/// rows. When there are too many columns, neighbours are averaged and columns become twice as long.
class Spectrograph {
public:
    /// Expects half overlapped frames of `lines` lines, `spacing` [Hz] apart, one every `hop` [s].
    Spectrograph(double spacing, double hop, std::size_t lines, SpectrogramBounds bounds = {});

    /// Takes the next frame's density [unit²/Hz], shape [line]; lines beyond the last row are left out.
    void push(std::span<const double> density);

    /// Returns the spectrogram of the frames so far.
    Spectrogram spectrogram() const;

private:
    void merge();

    double spacing_;
    double hop_;
    std::size_t most_columns_;
    std::size_t pool_;  // lines per row
    std::size_t rows_;
    std::size_t stride_ = 1;  // frames per column
    std::size_t filled_ = 0;  // frames in the last column
    std::vector<double> current_;
    std::vector<double> density_{};
};

/// Returns the spectrogram of a whole signal, Hann, half overlapped.
Spectrogram spectrogram(const Signal& signal, std::size_t size = 4096);

}  // namespace stridor::signal
