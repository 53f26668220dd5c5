#include "stridor/advice/sobol.hpp"

#include "stridor/base/check.hpp"

#include <array>

namespace stridor::advice {

namespace {

constexpr std::size_t digits = 32;
constexpr std::size_t most_degree = 7;

// one line of the table of Joe and Kuo: a primitive polynomial x^s + a1 x^(s-1) + ... + 1 and the
// first direction numbers
struct DirectionNumbers {
    unsigned degree = 0;                             // s
    unsigned coefficients = 0;                       // a, the bits a1 ... a(s-1)
    std::array<std::uint32_t, most_degree> first{};  // m1 ... ms
};

// dimensions 2 to 21; the first one is van der Corput's sequence
constexpr std::array<DirectionNumbers, most_sobol_dimensions - 1> table{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
}};

using Directions = std::array<std::uint32_t, digits>;

constexpr Directions van_der_corput() {
    Directions v{};
    for (std::size_t k = 0; k < digits; ++k)
        v[k] = std::uint32_t{1} << (digits - 1 - k);
    return v;
}

// Bratley and Fox (1988): v(k) = v(k-s) ^ (v(k-s) >> s) ^ the v(k-i) whose a(i) is set
constexpr Directions directions(const DirectionNumbers& line) {
    Directions v{};
    const std::size_t s = line.degree;
    for (std::size_t k = 0; k < s; ++k)
        v[k] = line.first[k] << (digits - 1 - k);
    for (std::size_t k = s; k < digits; ++k) {
        v[k] = v[k - s] ^ (v[k - s] >> s);
        for (std::size_t i = 1; i < s; ++i)
            if ((line.coefficients >> (s - 1 - i)) & 1U) v[k] ^= v[k - i];
    }
    return v;
}

constexpr std::array<Directions, most_sobol_dimensions> all_directions() {
    std::array<Directions, most_sobol_dimensions> all{};
    all[0] = van_der_corput();
    for (std::size_t k = 0; k < table.size(); ++k)
        all[k + 1] = directions(table[k]);
    return all;
}

constexpr std::array<Directions, most_sobol_dimensions> direction_numbers = all_directions();

// numbers out of a counter (SplitMix64, Steele, Lea, Flood 2014)
constexpr std::uint64_t mixed(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
}

std::uint32_t shift_of(const SobolShift& shift, std::size_t dimension) {
    return static_cast<std::uint32_t>(mixed(mixed(mixed(shift.seed) ^ shift.replicate) ^ dimension) >> 32U);
}

}  // namespace

std::vector<std::uint32_t> sobol_digits(std::size_t dimensions, std::uint32_t index) {
    STRIDOR_EXPECT(dimensions <= most_sobol_dimensions);
    std::vector<std::uint32_t> point(dimensions, 0);
    for (std::size_t k = 0; k < digits; ++k)
        if ((index >> k) & 1U)
            for (std::size_t dimension = 0; dimension < dimensions; ++dimension)
                point[dimension] ^= direction_numbers[dimension][k];
    return point;
}

std::vector<std::vector<double>> sobol_points(std::size_t dimensions, std::size_t count, const SobolShift& shift) {
    std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
    for (std::size_t index = 0; index < count; ++index) {
        const std::vector<std::uint32_t> point = sobol_digits(dimensions, static_cast<std::uint32_t>(index));
        for (std::size_t k = 0; k < dimensions; ++k)
            // the middle of the cell of 2^-32: never 0 nor 1
            points[index][k] = (static_cast<double>(point[k] ^ shift_of(shift, k)) + 0.5) * 0x1p-32;
    }
    return points;
}

}  // namespace stridor::advice
