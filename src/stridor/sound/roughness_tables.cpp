#include "stridor/sound/roughness_tables.hpp"

#include <algorithm>
#include <cstddef>

namespace stridor::sound {

namespace {

template <std::size_t size>
using Curve = std::array<CurvePoint, size>;

// critical-band rate over frequency: edges at whole Bark, centres between them
constexpr Curve<50> rates{{
    {0, 0},      {50, 0.5},     {100, 1},   {150, 1.5},   {200, 2},   {250, 2.5},    {300, 3},    {350, 3.5},
    {400, 4},    {450, 4.5},    {510, 5},   {570, 5.5},   {630, 6},   {700, 6.5},    {770, 7},    {840, 7.5},
    {920, 8},    {1000, 8.5},   {1080, 9},  {1170, 9.5},  {1270, 10}, {1370, 10.5},  {1480, 11},  {1600, 11.5},
    {1720, 12},  {1850, 12.5},  {2000, 13}, {2150, 13.5}, {2320, 14}, {2500, 14.5},  {2700, 15},  {2900, 15.5},
    {3150, 16},  {3400, 16.5},  {3700, 17}, {4000, 17.5}, {4400, 18}, {4800, 18.5},  {5300, 19},  {5800, 19.5},
    {6400, 20},  {7000, 20.5},  {7700, 21}, {8500, 21.5}, {9500, 22}, {10500, 22.5}, {12000, 23}, {13500, 23.5},
    {15500, 24}, {20000, 24.5},
}};

constexpr Curve<21> transmissions{{
    {10, 0},     {12, 1.15},    {13, 2.31},   {14, 3.85},  {15, 5.62},  {16, 6.92},  {16.5, 7.38},
    {17, 6.92},  {18, 4.23},    {18.5, 2.31}, {19, 0},     {20, -1.43}, {21, -2.59}, {21.5, -3.57},
    {22, -5.19}, {22.5, -7.41}, {23, -11.3},  {23.5, -20}, {24, -40},   {25, -130},  {26, -999},
}};

constexpr Curve<27> thresholds{{
    {0, 130},   {0.01, 70}, {0.17, 60}, {0.8, 30}, {1, 25},   {1.5, 20}, {2, 15},    {3.3, 10},  {4, 8.1},
    {5, 6.3},   {6, 5},     {8, 3.5},   {10, 2.5}, {12, 1.7}, {13.3, 0}, {15, -2.5}, {16, -4},   {17, -3.7},
    {18, -1.5}, {19, 1.4},  {20, 3.8},  {21, 5},   {22, 7.5}, {23, 15},  {24, 48},   {24.5, 60}, {25, 130},
}};

// over 0, 1, ... 24 Bark
constexpr std::array weights{0.15, 0.26, 0.38, 0.47, 0.54, 0.65, 0.76, 0.83, 0.90, 0.98, 0.98, 0.90, 0.80,
                             0.70, 0.62, 0.54, 0.49, 0.43, 0.39, 0.35, 0.30, 0.30, 0.30, 0.30, 0.30};

// responses to modulations, by the group of channels they hold for
constexpr Curve<15> up_to_2_bark{{
    {0, 0},
    {17, 0.8},
    {23, 0.95},
    {25, 0.975},
    {32, 1},
    {37, 0.975},
    {48, 0.9},
    {67, 0.8},
    {90, 0.7},
    {114, 0.6},
    {171, 0.4},
    {206, 0.3},
    {247, 0.2},
    {294, 0.1},
    {358, 0},
}};
constexpr Curve<14> up_to_7_bark{{
    {0, 0},
    {32, 0.8},
    {43, 0.95},
    {56, 1},
    {69, 0.975},
    {92, 0.9},
    {120, 0.8},
    {142, 0.7},
    {165, 0.6},
    {231, 0.4},
    {277, 0.3},
    {331, 0.2},
    {397, 0.1},
    {502, 0},
}};
constexpr Curve<20> up_to_10_bark{{
    {0, 0},       {23.5, 0.4}, {34, 0.6},  {47, 0.8},   {56, 0.9},  {63, 0.95}, {79, 1},
    {100, 0.975}, {115, 0.95}, {135, 0.9}, {159, 0.85}, {172, 0.8}, {194, 0.7}, {215, 0.6},
    {244, 0.5},   {290, 0.4},  {348, 0.3}, {415, 0.2},  {500, 0.1}, {645, 0},
}};
constexpr Curve<18> up_to_20_bark{{
    {0, 0},
    {19, 0.4},
    {44, 0.8},
    {52.5, 0.9},
    {58, 0.95},
    {75, 1},
    {101.5, 0.95},
    {114.5, 0.9},
    {132.5, 0.85},
    {143.5, 0.8},
    {165.5, 0.7},
    {197.5, 0.6},
    {241, 0.5},
    {290, 0.4},
    {348, 0.3},
    {415, 0.2},
    {500, 0.1},
    {645, 0},
}};
constexpr Curve<19> above{{
    {0, 0},     {15, 0.4},  {41, 0.8},   {49, 0.9},  {53, 0.965}, {64, 0.99}, {71, 1},
    {88, 0.95}, {94, 0.9},  {106, 0.85}, {115, 0.8}, {137, 0.7},  {180, 0.6}, {238, 0.5},
    {290, 0.4}, {348, 0.3}, {415, 0.2},  {500, 0.1}, {645, 0},
}};

}  // namespace

double value_at(std::span<const CurvePoint> curve, double place) {
    if (place <= curve.front().place) return curve.front().value;
    const auto above_it = std::upper_bound(curve.begin(), curve.end(), place,
                                           [](double x, const CurvePoint& point) { return x < point.place; });
    if (above_it == curve.end()) return curve.back().value;
    const CurvePoint& right = *above_it;
    const CurvePoint& left = *(above_it - 1);
    return left.value + (right.value - left.value) * ((place - left.place) / (right.place - left.place));
}

double critical_band_rate(double frequency) {
    return value_at(rates, frequency);
}

double transmission(double rate) {
    return value_at(transmissions, rate);
}

double hearing_threshold(double rate) {
    return value_at(thresholds, rate);
}

double modulation_weight(double rate) {
    const auto below = std::min(static_cast<std::size_t>(rate), weights.size() - 2);
    return weights[below] + (weights[below + 1] - weights[below]) * (rate - static_cast<double>(below));
}

double modulation_response(std::size_t channel, double frequency) {
    if (channel < 4) return value_at(up_to_2_bark, frequency);
    if (channel < 15) return value_at(up_to_7_bark, frequency);
    if (channel < 20) return value_at(up_to_10_bark, frequency);
    if (channel < 41) return value_at(up_to_20_bark, frequency);
    return value_at(above, frequency);
}

}  // namespace stridor::sound
