#pragma once

#include "stridor/model/structure.hpp"
#include "stridor/signal/spectrum.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

/// The shares of the free modes in the lines of a spectrum.
///
/// The velocity of a point is w.u'. In the modes of the structure with all contacts open, K phi = omega^2 M phi,
/// phi.M phi = 1, it is a sum, whatever the contacts do meanwhile:
///
///     w.u' = sum of v_k,   v_k = (w.phi_k) (phi_k.M u')
///
/// so its spectrum is a sum too, X = sum of X_k. Mode k contributes to the power of a line
///
///     S_k = Re(X_k X*),   sum of S_k = |X|^2
///
/// averaged over frames as Welch does. A mode that works against the others contributes a negative share.
namespace stridor::analysis {

/// The undamped modes of a structure whose contacts are all open.
struct OpenModes {
    std::vector<double> frequencies;  // [Hz] rising; a rigid motion has 0
    Eigen::MatrixXd shapes;           // phi, phi.M phi = 1; shape [dof][mode]
};

/// Returns all open modes. The mass must be positive definite. The cost is the cube of the degrees of freedom.
OpenModes open_modes(const model::Structure& structure);

/// Returns for each mode the row whose product with u' is v_k; shape [mode][dof]. The sum of all rows is the weights w.
Eigen::MatrixXd modal_rows(const OpenModes& modes, const Eigen::MatrixXd& mass, const Eigen::VectorXd& weights);

/// A spectrum, and the contribution of each mode.
struct ModalSpectrum {
    signal::Spectrum whole{};
    std::vector<std::vector<double>> parts{};  // [unit²/Hz] S_k; their sum is the whole's density; shape [mode][line]
};

/// Returns the spectrum of the sum of velocities v_k [m/s], shape [mode][sample], sampled at `rate` [Hz]. Frames of
/// `size` samples, half overlapped, through Hann's window; without a whole frame it has no frames. `size` must be even.
ModalSpectrum modal_spectrum(std::span<const std::vector<double>> velocities, double rate, std::size_t size);

/// A line of a spectrum, and the share of each mode.
struct ModalLine {
    double frequency = 0.0;      // [Hz]
    double mean_square = 0.0;    // [unit²] of a sinusoid with this line
    std::vector<double> shares;  // [1] shape [mode]; together 1
};

/// Returns the strongest lines within `depth` [dB] of the strongest, at most `most`, by rising frequency. Each is
/// higher than all within three lines of it. It includes the leakage of the window into the two lines at each side.
std::vector<ModalLine> modal_lines(const ModalSpectrum& spectrum, std::size_t most = 8, double depth = 50.0);

}  // namespace stridor::analysis
