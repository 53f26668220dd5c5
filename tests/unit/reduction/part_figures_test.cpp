#include "stridor/reduction/part_figures.hpp"

#include "stridor/reduction/craig_bampton.hpp"
#include "support/error_text.hpp"
#include "support/structures/lattice_part.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stridor::reduction {
namespace {

using support::chain_part;
using support::lattice_part;
using support::LatticeSupport;

TEST(PartSize, TellsTheMassOfEachDirection) {
    const PartSize size = part_size(chain_part(7, 1.0, 0.5));
    EXPECT_DOUBLE_EQ(size.mass[0], 3.5);
    EXPECT_EQ(size.mass[1], 0.0);
    EXPECT_EQ(size.rows, 7);
    EXPECT_FALSE(size.extent);
    EXPECT_EQ(guessed_units(size), nullptr);
}

TEST(PartVibration, RefusesAPartWithoutStiffness) {
    for (const double stiffness : {0.0, 1e-299}) {
        const ElasticPart part = chain_part(70, stiffness, 0.5);
        const auto thrown = support::thrown_by([&] { part_vibration(part, 6); });
        EXPECT_EQ(thrown.kind, ErrorKind::input);
        EXPECT_TRUE(thrown.says("the part has no stiffness")) << thrown.message;
    }
}

TEST(CraigBampton, RefusesAPartWithoutStiffness) {
    const ElasticPart part = chain_part(70, 0.0, 0.5);
    const auto thrown = support::thrown_by([&] { craig_bampton(part, {.boundary = {0}, .modes = 3}); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("the part has no stiffness")) << thrown.message;
}

TEST(PartSize, GuessesTheUnits) {
    const ElasticPart si = lattice_part({5, 4, 3}, LatticeSupport::free);
    const PartSize size = part_size(si);
    ASSERT_TRUE(size.extent);
    EXPECT_NEAR((*size.extent - Eigen::Vector3d(0.04, 0.03, 0.02)).norm(), 0.0, 1e-15);
    ASSERT_NE(guessed_units(size), nullptr);
    EXPECT_EQ(guessed_units(size)->name, "m-kg-s");
    const double density = density_in(size, unit_system("m-kg-s")).value();
    EXPECT_NEAR(density, size.mass[0] / (0.04 * 0.03 * 0.02), 1e-9 * density);
    ElasticPart tonnes = si;  // the same in mm and t
    tonnes.stiffness *= 1e-3;
    tonnes.mass *= 1e-3;
    for (auto& [node, position] : tonnes.positions)
        position *= 1e3;
    ASSERT_NE(guessed_units(part_size(tonnes)), nullptr);
    EXPECT_EQ(guessed_units(part_size(tonnes))->name, "mm-t-s");
    EXPECT_NEAR(density_in(part_size(tonnes), unit_system("mm-t-s")).value(), density, 1e-9 * density);
    EXPECT_FALSE(density_in(part_size(tonnes), unit_system("m-kg-s")));
    EXPECT_EQ(units_doubt(size, unit_system("m-kg-s")), "");
    EXPECT_TRUE(units_doubt(part_size(tonnes), unit_system("m-kg-s")).ends_with("Say --units mm-t-s?"));
    tonnes.mass *= 1e30;
    EXPECT_EQ(units_doubt(part_size(tonnes), unit_system("m-kg-s")),
              "in no system of units is its mass per volume a material's");
}

// bars of 2e4 N times their length, 0.04 kg/m: a wave runs along them at 707 m/s
TEST(PartSize, KnowsHowFastAWaveRuns) {
    const PartSize size = part_size(lattice_part({5, 4, 3}, LatticeSupport::free));
    ASSERT_TRUE(size.wave_speed);
    // within a factor of three: here bars across corners add more mass than stiffness
    EXPECT_GT(*size.wave_speed, std::sqrt(2e4 / 0.04) / 3.0);
    EXPECT_LT(*size.wave_speed, std::sqrt(2e4 / 0.04) * 3.0);
    EXPECT_FALSE(part_size(chain_part(7, 1.0, 0.5)).wave_speed);
}

// in mm and t, with one number of its material in SI
TEST(PartSize, TellsAModulusInPascalsAndADensityInSi) {
    ElasticPart millimetres = lattice_part({5, 4, 3}, LatticeSupport::free);
    millimetres.stiffness *= 1e-3;
    millimetres.mass *= 1e-3;
    for (auto& [node, position] : millimetres.positions)
        position *= 1e3;
    const auto doubt_of = [&](double stiffness, double mass, const char* units) {
        ElasticPart part = millimetres;
        part.stiffness *= stiffness;
        part.mass *= mass;
        return units_doubt(part_size(part), unit_system(units));
    };
    EXPECT_EQ(doubt_of(1.0, 1.0, "mm-t-s"), "");
    const std::string modulus =
        "in mm-t-s its numbers would be a material's, were its stiffness 1e-06 of what it is. Is the modulus of "
        "elasticity in Pa?";
    EXPECT_TRUE(doubt_of(1e6, 1.0, "mm-t-s").ends_with(modulus)) << doubt_of(1e6, 1.0, "mm-t-s");
    EXPECT_TRUE(doubt_of(1e6, 1.0, "m-kg-s").ends_with(modulus)) << doubt_of(1e6, 1.0, "m-kg-s");
    EXPECT_TRUE(doubt_of(1.0, 1e12, "mm-t-s").ends_with("were its mass 1e-12 of what it is. Is the density in kg/m^3?"))
        << doubt_of(1.0, 1e12, "mm-t-s");
}

TEST(PartVibration, CountsRigidBodyModes) {
    const PartVibration free = part_vibration(lattice_part({4, 3, 3}, LatticeSupport::free), 4);
    EXPECT_EQ(free.rigid_body_modes, 6);
    EXPECT_EQ(free.frequencies.size(), 4U);
    const PartVibration held = part_vibration(lattice_part({4, 3, 3}, LatticeSupport::top_held), 4);
    EXPECT_EQ(held.rigid_body_modes, 0);
    EXPECT_GT(held.frequencies.front(), 1.0);
    EXPECT_GT(held.highest_frequency, held.frequencies.back());
    // a mechanism: the chain without its wall
    ElasticPart loose = chain_part(80, 1e4, 0.1);
    loose.stiffness.coeffRef(0, 0) = 1e4;
    EXPECT_EQ(part_vibration(loose, 3).rigid_body_modes, 1);
    EXPECT_NEAR(part_vibration(loose, 3).frequencies.front(),
                2.0 * std::sqrt(1e5) * std::sin(std::numbers::pi / 160.0) / (2.0 * std::numbers::pi), 1e-7);
}

TEST(PartVibration, TakesNoLowFrequencyForARigidBody) {
    const PartVibration chain = part_vibration(chain_part(3000, 1e6, 1.0), 2);
    EXPECT_EQ(chain.rigid_body_modes, 0);
    EXPECT_NEAR(chain.frequencies.front(), 2e3 * std::sin(std::numbers::pi / 12002.0) / (2.0 * std::numbers::pi), 1e-9);
}

}  // namespace
}  // namespace stridor::reduction
