#pragma once

#include "stridor/advice/design_runner.hpp"
#include "stridor/advice/design_space.hpp"
#include "stridor/sweep/starts.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The chance of noise if parameters lie anywhere within their tolerances, by randomised quasi-Monte Carlo sampling
/// (sobol.hpp). docs/methods/advice.md, section 4.
namespace stridor::advice {

/// How a parameter is spread over its tolerance.
enum class Spread {
    uniform,  // every value within it is equally likely
    normal,   // standard deviation a third of the tolerance, cut off at the tolerance
};

inline constexpr std::array<std::string_view, 2> spread_names{"uniform", "normal"};

/// A tolerance that a user asks for by name: one of the two amounts.
struct AskedTolerance {
    std::string name;                  // a key, or a name that `quantity_key_called` knows
    std::optional<double> relative{};  // [1] of the present value: 0.1 for 10 %
    std::optional<double> absolute{};  // in the field's unit
    Spread spread = Spread::uniform;
};

/// A parameter that lies between value - tolerance and value + tolerance.
struct Tolerance {
    std::string key;
    double value = 0.0;      // in the field's unit, at present
    double tolerance = 0.0;  // in the field's unit, above zero
    Spread spread = Spread::uniform;
};

/// Returns the tolerances of a case. Throws `Error` (input) for unknown names, for invalid amounts, for tolerances that
/// leave the range of the field, and for more than `most_sobol_dimensions`.
std::vector<Tolerance> tolerances(const parameters::Case& c, std::span<const AskedTolerance> asked);

/// Returns the tolerances of a case for which nobody named any: those of series production (docs/methods/advice.md).
///
/// Preload and load +-20 %, friction +-10 %, damping +-30 %, stiffness +-10 %, mass +-5 %, angles +-2 deg, evenly. The
/// drive has none: the part has to bear it. mu_d and mu_s are spread by at most half of their difference, so that no
/// such design contradicts itself. A tolerance that would leave the range of its field is left out.
std::vector<Tolerance> default_tolerances(const parameters::Case& c);

/// Returns the friction coefficients that `default_tolerances` spread by less than usual, or not at all, since mu_d
/// must not exceed mu_s.
std::vector<std::string> narrowed_frictions(const parameters::Case& c);

/// Returns the value with a cumulative probability of 0 < p < 1, with the same bits on every machine.
double value_at(const Tolerance& tolerance, double probability);

/// A share estimated from samples, with its 95 % confidence interval.
struct Estimate {
    double share = 0.0;  // [1]
    double low = 0.0;    // [1]
    double high = 1.0;   // [1]
};

/// Independent shifts of the points: enough for a spread, few enough that each is dense.
inline constexpr std::size_t replicates = 16;

inline constexpr double confidence = 0.95;

/// Returns the share of samples with a property, from the number that had it in each replicate (shape [replicate],
/// `replicates` of them) out of `samples` per replicate.
///
/// Interval: Student's t over the means of the replicates. If 30 samples or fewer had the property, or lacked it, those
/// means are too coarse, and the interval is that of Clopper and Pearson (1934) for independent samples, which are
/// spread less evenly; if all means are equal, it is that of Wilson (1927).
Estimate estimate(std::span<const std::size_t> hits, std::size_t samples);

/// How the chance of noise is sampled. The same seed gives the same samples.
struct ChanceOptions {
    std::size_t samples = 2048;  // [1] rounded up to `replicates` times a power of two
    std::uint64_t seed = 1;
};

/// The number of samples if nobody asked for a chance [1].
inline constexpr std::size_t default_samples = 256;

/// The largest number of samples: more are of no use to an engineer.
inline constexpr std::size_t most_samples = std::size_t{1} << 24U;

/// The verdicts of a design within its tolerances.
struct Chance {
    std::vector<Tolerance> tolerances{};
    ChanceOptions options{};
    std::size_t samples = 0;                                         // [1] taken
    bool is_default = false;                                         // nobody named the tolerances
    Estimate noise{};                                                // some phase squeals, squeaks or creaks
    Estimate not_quiet{};                                            // or is undecided or has no result
    std::array<Estimate, sweep::verdict_words.size()> by_verdict{};  // of the loudest phase, by `verdict_words`
};

/// Samples designs within their tolerances, independent of each other, and runs them all. The result does not depend on
/// the number of threads.
Chance chance(std::span<const Tolerance> tolerances, const ChanceOptions& options, DesignRunner& runner);

}  // namespace stridor::advice
