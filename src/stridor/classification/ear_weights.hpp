#pragma once

#include <array>

/// The fitted numbers of the ear, by figure in the order of `ear_figures`, and by `EarOutcome`. bench/ear/train.py
/// writes this file.
namespace stridor::classification {

inline constexpr std::array<double, 14> ear_means{0.5121, 1.5877, 0.2855, -0.0364, 0.3074, 0.8431, 3.1872,
                                                  3.153,  0.1759, 0.166,  0.1262,  4.1733, 4.208,  0.9445};
inline constexpr std::array<double, 14> ear_scales{0.3912, 1.2955, 0.3039, 0.6848, 1.0378, 0.3847, 1.2768,
                                                   1.1477, 0.2518, 0.243,  0.2165, 2.7132, 1.6517, 0.1253};
inline constexpr std::array<double, 5> ear_biases{-0.2142, 1.3943, -1.4646, 0.3625, -0.078};
inline constexpr std::array<std::array<double, 14>, 5> ear_weights{
    std::array{-0.5528, -0.2114, 0.1737, 0.1741, 0.0971, 0.4914, 0.0665, -0.0075, 0.0005, -0.0556, -0.1805, 0.171,
               0.0988, 0.1255},
    std::array{-0.6296, -0.3585, 0.0001, 0.2881, -0.4132, 0.2553, 0.5131, -0.1052, -0.1235, 0.0025, -0.0563, -0.0585,
               -0.2501, -0.3683},
    std::array{0.724, 0.741, -0.0993, 0.0236, 0.3851, -0.5602, -0.5459, 0.0979, 0.2297, -0.3749, -0.3136, -0.4168,
               -0.1597, 0.4468},
    std::array{0.6403, -0.406, 0.1069, -0.0346, 0.2118, -0.502, -0.0959, -0.0867, -0.2673, -0.116, -0.1945, 0.4122,
               0.0998, -0.3366},
    std::array{-0.1819, 0.2349, -0.1813, -0.4513, -0.2808, 0.3154, 0.0622, 0.1014, 0.1607, 0.5441, 0.7449, -0.1079,
               0.2112, 0.1326},
};

}  // namespace stridor::classification
