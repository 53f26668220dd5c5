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
inline constexpr EarStanding ear_line{0.6, 0.7647};  // tone_presence

inline constexpr std::array<double, 14> ear_means{0.5729, 1.7678, 0.2983, 0.0122, 0.3033, 0.8141, 2.1437,
                                                  3.1149, 0.1897, 0.1558, 0.1251, 3.8452, 4.2142, 0.9433};
inline constexpr std::array<double, 14> ear_scales{0.3886, 1.3074, 0.3134, 0.7283, 1.0393, 0.4021, 1.0095,
                                                   1.1485, 0.2563, 0.229,  0.212,  2.2223, 1.6245, 0.1213};
inline constexpr std::array<double, 5> ear_biases{-1.1943, 1.4478, -0.8913, 0.5609, 0.0769};
inline constexpr std::array<std::array<double, 14>, 5> ear_weights{
    std::array{-0.3898, -0.269, 0.056, 0.0514, 0.1519, 0.3135, -0.0011, -0.1691, -0.0438, -0.2176, -0.132, -0.1111,
               0.0494, 0.1189},
    std::array{-0.4217, -0.1089, -0.0233, 0.2376, -0.2748, 0.186, 0.3827, -0.3026, 0.2098, 0.2253, -0.06, 0.1044,
               -0.0752, -0.2206},
    std::array{0.422, 0.5175, -0.2242, 0.0117, 0.2208, -0.4771, -0.4301, 0.0869, 0.0255, -0.3818, -0.2588, -0.2269,
               -0.1991, 0.3876},
    std::array{0.4316, -0.3284, 0.0842, -0.0747, 0.1037, -0.3572, -0.0559, 0.1287, -0.4012, -0.2498, -0.0587, 0.4377,
               0.035, -0.2568},
    std::array{-0.0421, 0.1887, 0.1073, -0.2259, -0.2017, 0.3348, 0.1044, 0.2561, 0.2098, 0.6239, 0.5095, -0.2041,
               0.1899, -0.029},
};

}  // namespace stridor::classification
