#include "stridor/analysis/modal_spectrum.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/decompositions.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/model/linear/linearised.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace stridor::analysis {

namespace {

constexpr std::size_t apart = 3;  // lines between two that are told from each other
constexpr std::size_t leak = 2;   // lines to each side into which Hann's window lets a sinusoid leak

// c_k / (rate Σw²) of Welch's spectrum
double factor_of_line(std::size_t line, std::size_t lines, double rate, double squares) {
    const bool is_end = line == 0 || line + 1 == lines;
    return (is_end ? 1.0 : 2.0) / (rate * squares);
}

bool is_peak(const std::vector<double>& density, std::size_t line) {
    const std::size_t first = line > apart ? line - apart : 0;
    const std::size_t last = std::min(line + apart, density.size() - 1);
    for (std::size_t other = first; other <= last; ++other)
        if (density[other] > density[line] || (other < line && density[other] == density[line])) return false;
    return density[line] > 0.0;
}

ModalLine line_at(const ModalSpectrum& spectrum, std::size_t line) {
    const std::size_t first = line > leak ? line - leak : 0;
    const std::size_t last = std::min(line + leak, spectrum.whole.density.size() - 1);
    const auto power = [&](const std::vector<double>& density) {
        double sum = 0.0;
        for (std::size_t k = first; k <= last; ++k)
            sum += density[k];
        return sum;
    };
    const double whole = power(spectrum.whole.density);
    ModalLine found{static_cast<double>(line) * spectrum.whole.spacing, whole * spectrum.whole.spacing, {}};
    for (const std::vector<double>& part : spectrum.parts)
        found.shares.push_back(power(part) / whole);
    return found;
}

}  // namespace

OpenModes open_modes(const model::Structure& structure) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        model::linearised_at_rest(structure).stiffness, structure.mass);
    OpenModes modes{{}, solver.eigenvectors()};
    for (const double squared : solver.eigenvalues())
        modes.frequencies.push_back(std::sqrt(std::max(0.0, squared)) / base::two_pi);
    return modes;
}

Eigen::MatrixXd modal_rows(const OpenModes& modes, const Eigen::MatrixXd& mass, const Eigen::VectorXd& weights) {
    STRIDOR_EXPECT(weights.size() == modes.shapes.rows());
    const Eigen::VectorXd moved = modes.shapes.transpose() * weights;
    return moved.asDiagonal() * (modes.shapes.transpose() * mass);
}

ModalSpectrum modal_spectrum(std::span<const std::vector<double>> velocities, double rate, std::size_t size) {
    STRIDOR_EXPECT(rate > 0.0 && size >= 2 && size % 2 == 0);
    const std::size_t lines = size / 2 + 1;
    const std::vector<double> window = signal::window(signal::Window::hann, size);
    double squares = 0.0;
    for (const double w : window)
        squares += w * w;
    ModalSpectrum spectrum;
    spectrum.whole.spacing = rate / static_cast<double>(size);
    spectrum.whole.bandwidth = spectrum.whole.spacing * signal::noise_bandwidth(window);
    spectrum.whole.unit = "m/s";
    spectrum.whole.density.assign(lines, 0.0);
    spectrum.parts.assign(velocities.size(), std::vector<double>(lines, 0.0));
    const std::size_t samples = velocities.empty() ? 0 : velocities.front().size();
    signal::Fourier fourier(size);
    std::vector<double> frame(size);
    std::vector<std::vector<std::complex<double>>> amplitudes(velocities.size());
    for (std::size_t begin = 0; begin + size <= samples; begin += size / 2) {
        std::vector<std::complex<double>> whole(lines);
        for (std::size_t mode = 0; mode < velocities.size(); ++mode) {
            for (std::size_t k = 0; k < size; ++k)
                frame[k] = window[k] * velocities[mode][begin + k];
            const std::span<const std::complex<double>> found = fourier.spectrum(frame);
            amplitudes[mode].assign(found.begin(), found.end());
            for (std::size_t line = 0; line < lines; ++line)
                whole[line] += found[line];
        }
        for (std::size_t line = 0; line < lines; ++line) {
            const double factor = factor_of_line(line, lines, rate, squares);
            spectrum.whole.density[line] += factor * std::norm(whole[line]);
            for (std::size_t mode = 0; mode < velocities.size(); ++mode)
                spectrum.parts[mode][line] += factor * (amplitudes[mode][line] * std::conj(whole[line])).real();
        }
        ++spectrum.whole.frames;
    }
    const auto frames = static_cast<double>(std::max<std::size_t>(spectrum.whole.frames, 1));
    for (double& density : spectrum.whole.density)
        density /= frames;
    for (std::vector<double>& part : spectrum.parts)
        for (double& density : part)
            density /= frames;
    return spectrum;
}

std::vector<ModalLine> modal_lines(const ModalSpectrum& spectrum, std::size_t most, double depth) {
    const std::vector<double>& density = spectrum.whole.density;
    std::vector<std::size_t> peaks;
    // the mean is no vibration
    for (std::size_t line = 1; line < density.size(); ++line)
        if (is_peak(density, line)) peaks.push_back(line);
    std::stable_sort(peaks.begin(), peaks.end(), [&](std::size_t a, std::size_t b) { return density[a] > density[b]; });
    std::vector<ModalLine> lines;
    for (const std::size_t peak : peaks) {
        const bool is_weak = 10.0 * std::log10(density[peak] / density[peaks.front()]) < -depth;
        if (is_weak || lines.size() == most) break;
        lines.push_back(line_at(spectrum, peak));
    }
    std::sort(lines.begin(), lines.end(),
              [](const ModalLine& a, const ModalLine& b) { return a.frequency < b.frequency; });
    return lines;
}

}  // namespace stridor::analysis
