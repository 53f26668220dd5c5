#pragma once

#include <array>

/// The fitted numbers of the ear, by figure in the order of `ear_figures`, and by `EarOutcome`. bench/ear/train.py
/// writes this file.
namespace stridor::classification {

inline constexpr std::array<double, 13> ear_means{0.4977, 1.5149, 0.2607, -0.0294, 0.3047, 0.8434, 3.2179,
                                                  3.2916, 0.1912, 0.1236, 4.4808,  4.087,  0.9383};
inline constexpr std::array<double, 13> ear_scales{0.4013, 1.3172, 0.3023, 0.6805, 1.0373, 0.3849, 1.3351,
                                                   1.1608, 0.2588, 0.2055, 2.8147, 1.7333, 0.1328};
inline constexpr std::array<double, 5> ear_biases{-0.2371, 1.3782, -1.4923, 0.3884, -0.0373};
inline constexpr std::array<std::array<double, 13>, 5> ear_weights{
    std::array{-0.5457, -0.2197, 0.2038, 0.1709, 0.0688, 0.4877, 0.0882, -0.0706, -0.0763, -0.193, 0.2118, 0.1427,
               0.1127},
    std::array{-0.567, -0.3526, -0.0679, 0.2867, -0.4329, 0.2991, 0.5128, -0.0785, -0.2276, -0.0213, -0.0322, -0.2212,
               -0.3703},
    std::array{0.7305, 0.7163, -0.0822, 0.0228, 0.4292, -0.5711, -0.5556, -0.0039, 0.1879, -0.473, -0.4325, -0.1258,
               0.4551},
    std::array{0.6166, -0.4219, 0.1381, -0.0699, 0.2103, -0.5106, -0.17, -0.1196, -0.2985, -0.1922, 0.4596, 0.04,
               -0.374},
    std::array{-0.2344, 0.278, -0.1918, -0.4106, -0.2755, 0.2949, 0.1246, 0.2726, 0.4144, 0.8795, -0.2066, 0.1643,
               0.1765},
};

}  // namespace stridor::classification
