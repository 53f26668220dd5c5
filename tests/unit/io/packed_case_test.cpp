#include "stridor/io/case/packed_case.hpp"

#include "stridor/base/packed_bytes.hpp"
#include "stridor/io/case/case_changes.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/expected_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::io {
namespace {

using parameters::Case;
using parameters::OwnContact;
using parameters::OwnStructure;

constexpr std::size_t many = 400;  // rows: 160,000 numbers a matrix

std::vector<double> numbers(std::size_t count, double seed) {
    std::vector<double> list(count);
    std::iota(list.begin(), list.end(), seed);
    for (double& number : list)
        number = std::sqrt(number);
    return list;
}

OwnContact full_contact(std::size_t k) {
    OwnContact contact{"lip " + std::to_string(k), numbers(many, 1.0 + static_cast<double>(k)), numbers(many, 2.0)};
    contact.second_tangent = numbers(k % 2 == 0 ? many : 0, 3.0);
    contact.initial_gap = -0.1 / 3.0;
    contact.interface = "edge";
    if (k % 3 == 0) contact.static_friction = 0.7, contact.kinetic_friction = 0.1 + 0.2;
    contact.drive_share = 1.0 / 3.0;
    contact.second_drive_share = 0.25;
    if (k % 2 == 1) contact.position = {0.1, -0.0, 1e-300};
    return contact;
}

// every member is something else than its default
Case full_case() {
    auto own = std::make_shared<OwnStructure>();
    own->origin = "matrices";
    for (std::size_t row = 0; row < many; ++row)
        own->row.push_back("row " + std::to_string(row));
    own->mass = numbers(many * many, 1.0);
    own->stiffness = numbers(many * many, 5.0);
    own->damping = numbers(many * many, 7.0);
    own->following = {0.01, 0.02, 0.03, 0.04};
    own->load = numbers(many, 8.0);
    own->force = numbers(many, 9.0);
    own->initial_displacement = numbers(many, 10.0);
    own->initial_velocity = numbers(many, 11.0);
    for (std::size_t k = 0; k < 300; ++k)
        own->contacts.push_back(full_contact(k));
    own->outputs = {{"glass", numbers(many, 12.0)}, {"frame", numbers(many, 13.0)}};
    own->outline = {{{1.0, 2.0, 3.0}, numbers(many, 14.0), numbers(many, 15.0)}};
    Case c = parameters::paper_case(parameters::PaperCase::squeal);
    c.own_structure = own;
    c.run.engine = parameters::Engine::moreau;  // the one that takes second tangents
    return c;
}

void expect_same_contact(const OwnContact& a, const OwnContact& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.tangent, b.tangent);
    EXPECT_EQ(a.second_tangent, b.second_tangent);
    EXPECT_EQ(a.initial_gap, b.initial_gap);
    EXPECT_EQ(a.interface, b.interface);
    EXPECT_EQ(a.static_friction, b.static_friction);
    EXPECT_EQ(a.kinetic_friction, b.kinetic_friction);
    EXPECT_EQ(a.preload_share, b.preload_share);
    EXPECT_EQ(a.drive_share, b.drive_share);
    EXPECT_EQ(a.second_drive_share, b.second_drive_share);
    EXPECT_EQ(a.position, b.position);
}

TEST(PackedCase, IsWholeHoweverLarge) {
    const Case c = full_case();
    const OwnStructure& a = *c.own_structure;
    const Case again = unpacked_case(packed_case(c));
    ASSERT_NE(again.own_structure, nullptr);
    const OwnStructure& b = *again.own_structure;
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.row, b.row);
    EXPECT_EQ(a.mass, b.mass);
    EXPECT_EQ(a.stiffness, b.stiffness);
    EXPECT_EQ(a.damping, b.damping);
    EXPECT_EQ(a.following.ratio, b.following.ratio);
    EXPECT_EQ(a.following.loss_factor, b.following.loss_factor);
    EXPECT_EQ(a.following.rayleigh_mass, b.following.rayleigh_mass);
    EXPECT_EQ(a.following.rayleigh_stiffness, b.following.rayleigh_stiffness);
    EXPECT_EQ(a.load, b.load);
    EXPECT_EQ(a.force, b.force);
    EXPECT_EQ(a.initial_displacement, b.initial_displacement);
    EXPECT_EQ(a.initial_velocity, b.initial_velocity);
    ASSERT_EQ(a.contacts.size(), b.contacts.size());
    for (std::size_t k = 0; k < a.contacts.size(); ++k)
        expect_same_contact(a.contacts[k], b.contacts[k]);
    ASSERT_EQ(b.outputs.size(), 2U);
    EXPECT_EQ(a.outputs[1].name, b.outputs[1].name);
    EXPECT_EQ(a.outputs[1].weights, b.outputs[1].weights);
    ASSERT_EQ(b.outline.size(), 1U);
    EXPECT_EQ(a.outline[0].position, b.outline[0].position);
    EXPECT_EQ(a.outline[0].along, b.outline[0].along);
    EXPECT_EQ(a.outline[0].across, b.outline[0].across);
    EXPECT_EQ(parameters::canonical_text(c), parameters::canonical_text(again));
    EXPECT_EQ(packed_case(again), packed_case(c));
}

TEST(PackedCase, OfNoStructureIsThatCase) {
    for (const auto which : {parameters::PaperCase::squeal, parameters::PaperCase::creak}) {
        const Case c = parameters::paper_case(which);
        const Case again = unpacked_case(packed_case(c));
        EXPECT_EQ(parameters::canonical_text(again), parameters::canonical_text(c));
        EXPECT_EQ(again.title, c.title);
    }
}

TEST(PackedCase, OfReadyFilesIsTheirCase) {
    for (const std::string& name : ready_file_names()) {
        if (name == "schema") continue;
        const TomlDocument document = parse_toml({ready_file(name), name, {}});
        const Case c = document.find("chart") != nullptr ? read_base_case(document) : read_case(document);
        const Case again = unpacked_case(packed_case(c));
        EXPECT_EQ(parameters::canonical_text(again), parameters::canonical_text(c)) << name;
        EXPECT_EQ(case_toml(again), case_toml(c)) << name;
        EXPECT_EQ(case_toml(read_case({case_toml(c), name, {}})), case_toml(c)) << name;
    }
}

// the first form had a text of TOML in place of entries
TEST(PackedCase, OfTheFirstFormIsRead) {
    const Case c = parameters::paper_case(parameters::PaperCase::squeal);
    const double none = 0.0;
    base::Packing first;
    first.add("stridor.case/1");
    first.add(case_toml(c, {.comments = Comments::none, .heading = ""}));
    first.add(std::string_view());
    first.add(std::string_view());
    first.add(std::string_view(reinterpret_cast<const char*>(&none), sizeof none));
    const Case again = unpacked_case(first.take());
    EXPECT_EQ(parameters::canonical_text(again), parameters::canonical_text(c));
    EXPECT_EQ(again.title, c.title);
}

TEST(PackedCase, HasTheSamplesOfItsDrive) {
    Case c = parameters::paper_case(parameters::PaperCase::squeal);
    c.drive = {};
    c.drive.kind = parameters::DriveKind::sampled;
    c.drive.file = "gone.csv";
    c.drive.times = numbers(5000, 0.0);
    c.drive.velocities = numbers(5000, 2.0);
    const Case again = unpacked_case(packed_case(c));
    EXPECT_EQ(again.drive.times, c.drive.times);
    EXPECT_EQ(again.drive.velocities, c.drive.velocities);
}

// whatever is missing or changed is refused, or is another case; nothing crashes
TEST(PackedCase, OfBrokenBytesIsRefused) {
    Case c = full_case();
    auto small = std::make_shared<OwnStructure>(*c.own_structure);
    small->contacts.resize(2);
    c.own_structure = small;
    const std::string bytes = packed_case(c);
    for (std::size_t length = 0; length < bytes.size(); length += 1 + length / 8)
        EXPECT_EQ(support::error_of([&] { unpacked_case(std::string_view(bytes).substr(0, length)); })->kind(),
                  ErrorKind::input);
    EXPECT_TRUE(support::error_of([&] { unpacked_case(bytes + "x"); }));
    EXPECT_TRUE(support::error_of([&] { unpacked_case("7:case"); }));
    // another number of rows than the matrices have
    small->row.pop_back();
    EXPECT_TRUE(support::error_of([&] { unpacked_case(packed_case(c)); }));
    small->row.push_back("u");
    small->contacts[1].tangent.pop_back();
    EXPECT_TRUE(support::error_of([&] { unpacked_case(packed_case(c)); }));
}

TEST(PackedCase, OfManyContactsAndLoadsTakesChanges) {
    const Case c = changed(full_case(), std::vector<CaseChange>{{"mu_d", 0.125}});
    EXPECT_EQ(c.contact().kinetic_friction, 0.125);
    EXPECT_EQ(c.own_structure->load.size(), many);
}

}  // namespace
}  // namespace stridor::io
