// A strip of rubber on a moving surface (the Taylor engine): shares against those of a prototype written apart from it,
// and which of its reductions are doubted.

#include "stridor/model/contact/contact_compliance.hpp"
#include "support/effort.hpp"
#include "support/many_contacts.hpp"
#include "support/structures/meshed_strip.hpp"
#include "support/structures/rubber_strip.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace stridor {
namespace {

using integration::Motion;
using support::expect_sound;
using support::open_share;
using support::run_taylor;
using support::shares;
using support::slip_share;
using support::stick_share;

std::array<double, 3> mean_shares(const Motion& motion) {
    std::array<double, 3> mean{};
    for (const auto& contact : shares(motion))
        for (std::size_t state = 0; state < 3; ++state)
            mean[state] += contact[state] / static_cast<double>(shares(motion).size());
    return mean;
}

// 40 degrees of freedom, five contacts, lumped mass
TEST(Strip, HasTheMeanSharesOfThePrototype) {
    const support::RubberStrip strip =
        support::read_strip(STRIDOR_SOURCE_DIR "/tests/fixtures/structures/strip_s1.txt");
    const Motion motion = run_taylor(strip.structure, strip.velocity, strip.start, support::strip_watched);
    expect_sound(motion);
    const std::array<double, 3> mean = mean_shares(motion);
    EXPECT_NEAR(mean[stick_share], 0.8335, support::strip_scatter);
    EXPECT_NEAR(mean[slip_share], 0.1665, support::strip_scatter);
    EXPECT_NEAR(mean[open_share], 0.0, support::effort(1e-4, 1e-3));
}

// the mesh of that strip has its modes, its loads and what impulses do to it
TEST(Strip, OfAMeshIsThatOfThePrototype) {
    const support::RubberStrip read = support::read_strip(STRIDOR_SOURCE_DIR "/tests/fixtures/structures/strip_s1.txt");
    const support::RubberStrip meshed = support::meshed_strip(4, support::MeshMass::lumped);
    const integration::ModalStructure wanted = integration::modal_structure(read.structure);
    const integration::ModalStructure found = integration::modal_structure(meshed.structure);
    ASSERT_EQ(found.modes(), wanted.modes());
    for (std::size_t j = 0; j < wanted.modes(); ++j)
        EXPECT_NEAR(found.square_frequency[j], wanted.square_frequency[j], 1e-9 * wanted.square_frequency.back());
    for (std::size_t k = 0; k < 5; ++k) {
        const auto load = [&](const support::RubberStrip& strip) {
            return strip.structure.contacts[k].normal.dot(strip.structure.load);
        };
        EXPECT_NEAR(load(meshed), load(read), 1e-6);
    }
    const Eigen::MatrixXd difference =
        model::contact_compliance(meshed.structure) - model::contact_compliance(read.structure);
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-9);
}

// 80 degrees of freedom, ten contacts
TEST(Strip, OfTenContactsHasTheMeanSharesOfThePrototype) {
    const support::RubberStrip strip = support::meshed_strip(9, support::MeshMass::lumped);
    const Motion motion = run_taylor(strip.structure, strip.velocity, strip.start,
                                     {support::effort(0.4, 0.2), support::effort(0.3, 0.1)});
    expect_sound(motion);
    const double scatter = support::effort(0.005, 0.05);
    const std::array<double, 3> mean = mean_shares(motion);
    EXPECT_NEAR(mean[stick_share], 0.7270, scatter);
    EXPECT_NEAR(mean[slip_share], 0.2160, scatter);
    EXPECT_NEAR(mean[open_share], 0.0570, scatter);
}

// consistent mass, and modes that were cut off: impacts throw neighbours off, and steps do not converge
TEST(Strip, WhoseContactsShareInertiaIsDoubted) {
    const auto doubts_of = [](const model::Structure& structure) {
        std::vector<std::string> names;
        for (std::size_t k = 0; k < structure.contacts.size(); ++k)
            names.push_back(std::to_string(k));
        return model::doubts(structure, names);
    };
    for (const int columns : {4, 9}) {
        const model::Structure lumped = support::meshed_strip(columns, support::MeshMass::lumped).structure;
        const model::Structure consistent = support::meshed_strip(columns, support::MeshMass::consistent).structure;
        EXPECT_TRUE(doubts_of(lumped).empty()) << columns;
        EXPECT_FALSE(doubts_of(consistent).empty()) << columns;
        EXPECT_FALSE(doubts_of(support::craig_bampton_of(consistent, 20)).empty()) << columns;
    }
    // a fourth of the modes is left
    const model::Structure lumped = support::meshed_strip(9, support::MeshMass::lumped).structure;
    EXPECT_FALSE(doubts_of(support::craig_bampton_of(lumped, 20)).empty());
}

}  // namespace
}  // namespace stridor
