#pragma once

#include <array>

/// The fitted numbers of the ear, by figure in the order of `ear_figures`, and by `EarOutcome`. bench/ear/train.py
/// writes this file.
namespace stridor::classification {

/// What may stand in a sound that is heard as quiet.
struct EarStanding {
    double least;  // [1] of its figure, from where on it stands there
    double right;  // [1] share of such verdicts that is right, by cross-validation over sources
};
inline constexpr EarStanding ear_row{0.5, 0.6667};   // train
inline constexpr EarStanding ear_line{0.6, 0.8571};  // tone_presence

inline constexpr std::array<double, 16> ear_means{0.6065, 1.8768, 0.3085, 0.0282, 0.3162, 0.7964,  0.2227, 2.1101,
                                                  3.1061, 0.1951, 0.1606, 0.1292, 3.8802, 11.3349, 4.2311, 0.9446};
inline constexpr std::array<double, 16> ear_scales{0.3802, 1.3021, 0.3157, 0.7453, 1.0408, 0.4015, 0.7263, 0.9903,
                                                   1.1598, 0.2617, 0.2326, 0.217,  2.2072, 6.1148, 1.6103, 0.1191};
inline constexpr std::array<double, 5> ear_biases{-1.3382, 1.3903, -0.8318, 0.6668, 0.1128};
inline constexpr std::array<std::array<double, 16>, 5> ear_weights{
    std::array{-0.341, -0.2633, 0.0046, 0.0884, 0.1579, 0.2661, -0.1901, -0.0074, -0.154, -0.0607, -0.2049, -0.1343,
               -0.0903, 0.0135, 0.0816, 0.1015},
    std::array{-0.2375, -0.1546, -0.0473, 0.2695, -0.1451, 0.1045, -0.5178, 0.3508, -0.2142, 0.1582, 0.2162, 0.0108,
               0.1137, 0.1317, -0.0411, -0.186},
    std::array{0.3538, 0.5525, -0.199, -0.0461, 0.1206, -0.3879, 0.4596, -0.4814, 0.0361, 0.0515, -0.3505, -0.2444,
               -0.2943, 0.0691, -0.2658, 0.3788},
    std::array{0.2465, -0.3259, 0.1647, -0.1327, -0.0459, -0.1874, 0.6464, -0.0846, 0.0341, -0.3072, -0.1764, -0.1387,
               0.4541, 0.0745, 0.0151, -0.2695},
    std::array{-0.0219, 0.1913, 0.0771, -0.1791, -0.0875, 0.2046, -0.3982, 0.2227, 0.298, 0.1582, 0.5156, 0.5067,
               -0.1833, -0.2888, 0.2102, -0.0249},
};

}  // namespace stridor::classification
