// The rubber block of CalculiX 2.20 (tests/fixtures/structures/calculix): what its matrices give, held against what
// CalculiX and a dense solver of another program found.

#include "stridor/io/structure/calculix.hpp"

#include "stridor/reduction/craig_bampton.hpp"
#include "stridor/reduction/lowest_modes.hpp"
#include "stridor/reduction/macneal.hpp"
#include "stridor/reduction/part_figures.hpp"
#include "stridor/reduction/reduction_errors.hpp"
#include "structure_texts.hpp"

#include <Eigen/SparseCholesky>

#include <array>
#include <cmath>

namespace stridor::io::structure {
namespace {

using reduction::BoundaryInertia;
using reduction::ElasticPart;

TEST(CalculixBlock, HasItsRowsPlacesAndSets) {
    const ElasticPart part = block_part();
    EXPECT_NO_THROW(expect_sound(part));
    EXPECT_EQ(rows_of(part), 144);
    EXPECT_EQ(describe(part.labels.front()), "1000.1");
    EXPECT_EQ(part.positions.size(), 60U);
    EXPECT_NEAR((part.positions.at("1059") - Eigen::Vector3d(0.02, 0.008, 0.012)).norm(), 0.0, 1e-12);
    ASSERT_NE(find_set(part, "foot"), nullptr);
    EXPECT_EQ(find_set(part, "foot")->nodes.size(), 12U);
    EXPECT_EQ(find_set(part, "NALL")->nodes.size(), 60U);
    EXPECT_TRUE(part.notes.empty());
}

TEST(CalculixBlock, IsTheSameWhicheverFileIsNamed) {
    for (const char* ending : {"mas", "dof", "inp"}) {
        const ElasticPart part = read_part({.files = {block_folder + "block." + ending}});
        EXPECT_EQ((part.stiffness - block_part().stiffness).norm(), 0.0) << ending;
    }
}

TEST(CalculixBlock, HasSixFrequenciesToTheNinthDigit) {
    constexpr std::array<double, 6> hertz{616.90354105,  744.14327110,  782.61723405,
                                          1526.56816073, 1613.22334521, 1759.64851784};
    const auto vibration = part_vibration(block_part(), 6);
    EXPECT_EQ(vibration.rigid_body_modes, 0);
    ASSERT_EQ(vibration.frequencies.size(), 6U);
    for (std::size_t k = 0; k < hertz.size(); ++k)
        EXPECT_NEAR(vibration.frequencies[k] / hertz[k], 1.0, 1e-11) << k;  // they are printed to 1e-8 Hz
}

TEST(CalculixBlock, IsGuessedToBeInMetresAndKilograms) {
    const auto size = part_size(block_part());
    ASSERT_NE(guessed_units(size), nullptr);
    EXPECT_EQ(guessed_units(size)->name, "m-kg-s");
    // the layer next to the support moves with it: of 20 x 8 x 12 mm at 1200 kg/m^3 some is missing
    EXPECT_GT(size.mass[0], 0.75 * 0.02 * 0.008 * 0.012 * 1200.0);
    EXPECT_LT(size.mass[0], 0.02 * 0.008 * 0.012 * 1200.0);
    EXPECT_NEAR(size.mass[1] / size.mass[0], 1.0, 1e-12);
}

TEST(CalculixBlock, SlidesAndSticksAtItsFrequencies) {
    const ElasticPart part = block_part();
    const auto frequencies_with = [&](std::initializer_list<const char*> held_names, Eigen::Index count) {
        std::vector<char> held(144, 0);
        for (const char* name : held_names)
            for (const Eigen::Index row : named_rows(part, name))
                held[static_cast<std::size_t>(row)] = 1;
        std::vector<Eigen::Triplet<double>> entries;
        Eigen::Index free = 0;
        for (std::size_t row = 0; row < held.size(); ++row)
            if (held[row] == 0) entries.emplace_back(static_cast<int>(row), static_cast<int>(free++), 1.0);
        reduction::SparseMatrix pick(144, free);
        pick.setFromTriplets(entries.begin(), entries.end());
        const reduction::SparseMatrix stiffness = pick.transpose() * part.stiffness * pick;
        const reduction::SparseMatrix mass = pick.transpose() * part.mass * pick;
        return reduction::lowest_modes(stiffness, mass, count).squared;
    };
    constexpr std::array<double, 5> sliding{757.1408, 802.5101, 835.8893, 1752.2227, 2131.7996};
    const Eigen::VectorXd slides = frequencies_with({"FOOT:3"}, 5);
    for (std::size_t k = 0; k < sliding.size(); ++k)
        EXPECT_NEAR(reduction::frequency_of(slides[static_cast<Eigen::Index>(k)]), sliding[k], 6e-5);
    constexpr std::array<double, 4> stuck{763.2341, 1038.5870, 1762.1397, 1997.0541};
    const Eigen::VectorXd sticks = frequencies_with({"FOOT:13"}, 4);
    for (std::size_t k = 0; k < stuck.size(); ++k)
        EXPECT_NEAR(reduction::frequency_of(sticks[static_cast<Eigen::Index>(k)]), stuck[k], 6e-5);
}

double worst_of(const reduction::StateErrors& state, std::size_t count) {
    double worst = 0.0;
    for (std::size_t k = 0; k < count; ++k)
        worst = std::max(worst, std::abs(relative_error(state.frequencies.at(k))));
    return worst;
}

TEST(CalculixBlock, IsReducedToTwelveModesWithin3e4) {
    const ElasticPart part = block_part();
    const reduction::ReductionRequest request{
        .boundary = named_rows(part, "FOOT"), .modes = 12, .inertia = BoundaryInertia::consistent};
    const auto reduced = craig_bampton(part, request);
    const auto errors = reduction_errors({part, request.boundary}, reduced, contact_states(reduced, 3), 6);
    ASSERT_EQ(errors.states.size(), 2U);
    EXPECT_LT(worst_of(errors.states[0], 3), 3e-4);
    EXPECT_LT(worst_of(errors.states[1], 3), 3e-3);
    ASSERT_TRUE(errors.flexibility);
    EXPECT_LT(*errors.flexibility, 1e-10);
}

// by MacNeal: open contacts exactly, stuck ones the closer the more modes are kept
TEST(CalculixBlock, IsReducedToFreeModesAsMeasuredElsewhere) {
    const ElasticPart part = block_part();
    const auto boundary = named_rows(part, "FOOT");
    const reduction::CondensedPart condensed(part, boundary);
    reduction::HeldRows stuck{"stuck", {}};
    for (std::size_t k = 0; k < boundary.size(); ++k)
        if (part.labels[static_cast<std::size_t>(boundary[k])].component != 2)
            stuck.held.push_back(static_cast<Eigen::Index>(k));
    const std::map<Eigen::Index, std::vector<double>> measured{
        {12, {1.8e-3, 7.4e-3, 1.5e-2, 4.3e-2}}, {24, {2.5e-4, 2.1e-3, 9.6e-3, 7.4e-3}}, {48, {2.1e-4, 6.6e-4, 2.4e-3}}};
    for (const auto& [modes, wanted] : measured) {
        const auto reduced = macneal(condensed, {.boundary = boundary, .modes = modes});
        const auto errors = reduction_errors(condensed, reduced, {{"open", {}}, stuck}, 4);
        EXPECT_LT(worst_of(errors.states[0], 3), 1e-11) << modes;
        for (std::size_t k = 0; k < wanted.size(); ++k)
            EXPECT_NEAR(relative_error(errors.states[1].frequencies.at(k)) / wanted[k], 1.0, 0.03) << modes << " " << k;
        ASSERT_TRUE(errors.flexibility);
        EXPECT_LT(*errors.flexibility, 1e-10);
    }
}

TEST(CalculixBlock, KeepsItsStaticFlexibility) {
    const ElasticPart part = block_part();
    const auto reduced = craig_bampton(part, {.boundary = named_rows(part, "FOOT"), .modes = 12});
    const Eigen::SimplicialLDLT<reduction::SparseMatrix> factor(reduced.part.stiffness);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(rows_of(reduced.part));
    load[2] = 1.0;  // the normal of node 1000
    const Eigen::VectorXd answer = factor.solve(load);
    EXPECT_NEAR(answer[2] / 2.267168351e-4, 1.0, 1e-9);  // printed to ten digits
    EXPECT_NEAR(answer[0] / -7.471572556e-5, 1.0, 1e-9);
    load[2] = 0.0;
    load[0] = 1.0;
    EXPECT_NEAR(factor.solve(load)[0] / 2.988139637e-4, 1.0, 1e-9);
}

// lumping moves frequencies as far as the mesh is coarse (here two elements across), and statics not at all
TEST(CalculixBlock, MayHaveLumpedContactInertia) {
    const ElasticPart part = block_part();
    const reduction::ReductionRequest request{.boundary = named_rows(part, "FOOT"), .modes = 12};
    const auto reduced = craig_bampton(part, request);
    const auto errors = reduction_errors({part, request.boundary}, reduced, contact_states(reduced, 3), 3);
    EXPECT_NEAR(worst_of(errors.states[0], 3), 0.034, 1e-3);
    EXPECT_NEAR(worst_of(errors.states[1], 3), 0.025, 1e-3);
    EXPECT_LT(*errors.flexibility, 1e-10);
    EXPECT_LT(errors.coupling, 1e-11);
}

}  // namespace
}  // namespace stridor::io::structure
