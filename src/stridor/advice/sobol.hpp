#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/// Points that fill a box more evenly than chance does: Sobol's sequence, randomised.
///
/// The first 2^m points of the sequence have exactly one in each interval [k, k + 1) 2^-m of every coordinate. A
/// *digital shift* adds a random number without carry (exclusive or) to all points of a coordinate: each point is then
/// evenly spread over the box, so that a mean over them is unbiased, while together they stay as even as they were. The
/// spread of the means over several independent shifts, *replicates*, says how well the mean is known.
///
/// Sources: I. M. Sobol', "On the distribution of points in a cube and the approximate evaluation of integrals", USSR
/// Comput. Math. Math. Phys. 7 (1967); direction numbers of S. Joe and F. Y. Kuo, "Constructing Sobol sequences with
/// better two-dimensional projections", SIAM J. Sci. Comput. 30 (2008), new-joe-kuo-6; digital shifts: P. L'Ecuyer and
/// C. Lemieux, "Recent advances in randomized quasi-Monte Carlo methods" (2002).
namespace stridor::advice {

/// The number of coordinates for which there are direction numbers.
inline constexpr std::size_t most_sobol_dimensions = 21;

/// The random shift: the same numbers give the same points.
struct SobolShift {
    std::uint64_t seed = 0;
    std::uint64_t replicate = 0;
};

/// Returns point number `index` of the sequence without a shift, each coordinate as 32 binary digits after the point;
/// shape [dimension].
std::vector<std::uint32_t> sobol_digits(std::size_t dimensions, std::uint32_t index);

/// Returns the first `count` points, shifted, each coordinate in (0, 1); shape [point][dimension]. At most
/// `most_sobol_dimensions` dimensions.
std::vector<std::vector<double>> sobol_points(std::size_t dimensions, std::size_t count, const SobolShift& shift);

}  // namespace stridor::advice
