// Shares of lines against closed forms: all modes together are the whole, and a mode that moves alone has all of it.

#include "stridor/analysis/modal_spectrum.hpp"

#include "stridor/model/built/bowed_string.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace stridor::analysis {
namespace {

constexpr double two_pi = 6.283185307179586476925;
constexpr double rate = 4096.0;  // [Hz]

std::vector<double> sinusoid(double amplitude, double frequency, double phase, std::size_t samples = 4096) {
    std::vector<double> values;
    for (std::size_t k = 0; k < samples; ++k)
        values.push_back(amplitude * std::cos(two_pi * frequency * static_cast<double>(k) / rate + phase));
    return values;
}

model::Structure coupled_pair() {
    model::Structure structure = model::structure_of_size(2);
    structure.mass << 2.0, 0.5, 0.5, 1.0;
    structure.stiffness << 5e4, -2e4, -2e4, 9e4;
    return structure;
}

TEST(OpenModes, AreOrthonormalInTheMassAndStiffness) {
    const model::Structure structure = coupled_pair();
    const OpenModes modes = open_modes(structure);
    const Eigen::Matrix2d mass = modes.shapes.transpose() * structure.mass * modes.shapes;
    EXPECT_LT((mass - Eigen::Matrix2d::Identity()).norm(), 1e-14);
    const Eigen::Matrix2d stiffness = modes.shapes.transpose() * structure.stiffness * modes.shapes;
    for (int k = 0; k < 2; ++k)
        EXPECT_NEAR(stiffness(k, k), std::pow(two_pi * modes.frequencies[static_cast<std::size_t>(k)], 2), 1e-9);
    EXPECT_LT(modes.frequencies[0], modes.frequencies[1]);
}

TEST(OpenModes, OfAMotionAddUpToIt) {
    const model::Structure structure = coupled_pair();
    const Eigen::Vector2d weights(0.3, -1.7);
    const Eigen::MatrixXd rows = modal_rows(open_modes(structure), structure.mass, weights);
    EXPECT_LT((rows.colwise().sum().transpose() - weights).norm(), 1e-14);
    // a motion in one mode is that mode's alone
    const OpenModes modes = open_modes(structure);
    const Eigen::Vector2d given = rows * modes.shapes.col(1);
    EXPECT_NEAR(given(0), 0.0, 1e-14);
    EXPECT_NEAR(given(1), weights.dot(modes.shapes.col(1)), 1e-14);
}

// 64 Hz stands on a line of 1 Hz; a sinusoid of amplitude a has a²/2
TEST(ModalSpectrum, OfOneModeIsAllItsOwn) {
    const std::vector<std::vector<double>> parts{std::vector<double>(4096, 0.0), sinusoid(0.2, 64.0, 0.3)};
    const std::vector<ModalLine> lines = modal_lines(modal_spectrum(parts, rate, 4096));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].frequency, 64.0);
    EXPECT_NEAR(lines[0].mean_square, 0.02, 1e-12);
    EXPECT_EQ(lines[0].shares, (std::vector<double>{0.0, 1.0}));
}

// at one line, amplitudes 3 and 1 with opposite signs: the whole is 2, shares 3/2 and -1/2; a quarter of a turn apart
// they do not know of each other, 9/10 and 1/10
TEST(ModalSpectrum, SharesALineByWhatEachModeAddsToIt) {
    const std::vector<std::vector<double>> against{sinusoid(3.0, 100.0, 0.0), sinusoid(-1.0, 100.0, 0.0)};
    const std::vector<ModalLine> opposed = modal_lines(modal_spectrum(against, rate, 1024));
    ASSERT_EQ(opposed.size(), 1U);
    EXPECT_NEAR(opposed[0].shares[0], 1.5, 1e-12);
    EXPECT_NEAR(opposed[0].shares[1], -0.5, 1e-12);
    const std::vector<std::vector<double>> turned{sinusoid(3.0, 100.0, 0.0), sinusoid(1.0, 100.0, 0.25 * two_pi)};
    const std::vector<ModalLine> apart = modal_lines(modal_spectrum(turned, rate, 1024));
    EXPECT_NEAR(apart.at(0).shares[0], 0.9, 1e-12);
    EXPECT_NEAR(apart.at(0).shares[1], 0.1, 1e-12);
}

TEST(ModalSpectrum, IsTheSumOfItsPartsAndThatOfWelch) {
    std::vector<std::vector<double>> parts(3);
    std::vector<double> whole(4096, 0.0);
    std::uint64_t state = 1;
    for (std::vector<double>& part : parts)
        for (double& sample : whole) {
            state = state * 6364136223846793005U + 1442695040888963407U;
            part.push_back(static_cast<double>(state >> 40U) / 16777216.0 - 0.5);
            sample += part.back();
        }
    const ModalSpectrum spectrum = modal_spectrum(parts, rate, 512);
    const signal::Spectrum welch = signal::welch({rate, "m/s", whole}, {512, signal::Window::hann});
    ASSERT_EQ(spectrum.whole.frames, welch.frames);
    EXPECT_EQ(spectrum.whole.spacing, welch.spacing);
    EXPECT_NEAR(spectrum.whole.bandwidth, welch.bandwidth, 1e-12);
    for (std::size_t line = 0; line < welch.density.size(); ++line) {
        const double sum = spectrum.parts[0][line] + spectrum.parts[1][line] + spectrum.parts[2][line];
        EXPECT_NEAR(spectrum.whole.density[line], welch.density[line], 1e-13 * welch.density[line]);
        EXPECT_NEAR(sum, welch.density[line], 1e-13 * welch.density[line]);
    }
    for (const ModalLine& line : modal_lines(spectrum))
        EXPECT_NEAR(std::accumulate(line.shares.begin(), line.shares.end(), 0.0), 1.0, 1e-12);
}

TEST(ModalSpectrum, OfNothingHasNoLines) {
    EXPECT_TRUE(modal_lines(modal_spectrum({}, rate, 64)).empty());
    const std::vector<std::vector<double>> silence{std::vector<double>(256, 0.0)};
    EXPECT_TRUE(modal_lines(modal_spectrum(silence, rate, 64)).empty());
}

// each harmonic of a string is one of its modes: at 200 Hz k it is the k-th that moves the bow's point
TEST(ModalSpectrum, OfHelmholtzMotionGivesEachHarmonicItsMode) {
    const model::BowedString string;
    constexpr int modes = 6;
    const model::Structure structure = model::bowed_string(string, modes);
    const OpenModes open = open_modes(structure);
    const Eigen::MatrixXd rows = modal_rows(open, structure.mass, structure.contacts.front().tangent);
    const Eigen::VectorXd start = model::helmholtz_motion(string, modes, 0.1);
    std::vector<std::vector<double>> velocities(open.frequencies.size());
    for (std::size_t sample = 0; sample < 8192; ++sample) {
        Eigen::VectorXd velocity = start;
        for (int k = 0; k < modes; ++k)
            velocity(k) *= std::cos(two_pi * string.frequency * (k + 1) * static_cast<double>(sample) / 16384.0);
        for (std::size_t mode = 0; mode < velocities.size(); ++mode)
            velocities[mode].push_back(rows.row(static_cast<Eigen::Index>(mode)).dot(velocity));
    }
    const std::vector<ModalLine> lines = modal_lines(modal_spectrum(velocities, 16384.0, 8192));
    ASSERT_EQ(lines.size(), 6U);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        EXPECT_NEAR(lines[k].frequency, 200.0 * static_cast<double>(k + 1), 2.0);
        std::size_t most = 0;
        for (std::size_t mode = 0; mode < open.frequencies.size(); ++mode)
            if (lines[k].shares[mode] > lines[k].shares[most]) most = mode;
        EXPECT_NEAR(open.frequencies[most], 200.0 * static_cast<double>(k + 1), 1e-6);
        EXPECT_NEAR(lines[k].shares[most], 1.0, 1e-6);
    }
}

}  // namespace
}  // namespace stridor::analysis
