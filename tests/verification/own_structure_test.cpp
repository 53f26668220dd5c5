// Structures of a user's own, from case files: the chain's closed form, the bowed string, a strip of rubber from
// matrices in CSV.

#include "stridor/parameters/own_structure.hpp"

#include "stridor/integration/run/initial_state.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/structure/part_files.hpp"
#include "stridor/io/structure/reduced_netcdf.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/model/built/chain_on_belt.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/reduction/craig_bampton.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "support/many_contacts.hpp"
#include "support/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace stridor {
namespace {

using integration::Motion;

parameters::Case read_ready(const std::string& name, std::vector<std::string> overrides) {
    return io::read_case(io::TomlSource{io::ready_file(name), name, std::move(overrides)});
}

Motion run_with_history(const parameters::Case& c) {
    record::Request request;
    request.history = record::KeepHistory::yes;
    return integration::simulate(c, request);
}

void expect_times(const record::ContactHistory& history, const std::vector<double>& times, double tolerance) {
    ASSERT_GE(history.size(), times.size() + 1);
    for (std::size_t n = 0; n < times.size(); ++n)
        EXPECT_NEAR(history[n + 1].from, times[n], tolerance) << "event " << n;
}

TEST(OwnStructure, ChainOfEqualBlocksHasItsClosedForm) {
    const Motion motion = run_with_history(read_ready("chain", {"run.duration=40", "run.window=39"}));
    EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
    const double until_stuck = std::asin(0.2);
    const double first = until_stuck + (1.0 - 0.5 * (1.0 - std::cos(until_stuck))) / 0.1;
    const double slips = 2.0 * (std::numbers::pi - std::atan(5.0));
    ASSERT_EQ(motion.record.histories.size(), 2U);
    for (const record::ContactHistory& history : motion.record.histories)
        expect_times(history, {until_stuck, first, first + slips, first + slips + 10.0}, 1e-12);
}

// what the file says is what a program builds
TEST(OwnStructure, ChainHasTheMatricesOfItsBuilder) {
    const model::Structure read = model::structure_of(read_ready("chain", {}));
    const model::ChainBlock block{.friction = model::Coulomb{1.0, 0.5}};
    const model::Structure built = model::chain_on_belt({block, block}, 1.2);
    EXPECT_EQ(read.mass, built.mass);
    EXPECT_EQ(read.stiffness, built.stiffness);
    EXPECT_EQ(read.load, built.load);
    EXPECT_EQ(read.contacts[1].friction, built.contacts[1].friction);
}

TEST(OwnStructure, ChainOfUnequalStartHasTheEventsOfRungeKutta) {
    std::string text = io::ready_file("chain");
    text.insert(text.find("\n[contact]"), "initial_displacement = [0.3, 0, 0, 0]\n");
    const Motion motion =
        run_with_history(io::read_case(io::TomlSource{text, "chain", {"run.duration=40", "run.window=39"}}));
    expect_times(motion.record.histories[0],
                 {2.066157008309, 8.792909821550, 13.115476994928, 22.12023972075, 25.45689449152, 35.42627773191},
                 1e-10);
}

// one slip a period, at the string's pitch
TEST(OwnStructure, StringMovesAsHelmholtzSays) {
    const Motion motion = integration::simulate(read_ready("string", {}));
    EXPECT_NEAR(support::shares(motion).front()[0], 0.1393, 1e-4);
}

/// The strip's numbers as they stand in its fixture: row by row, blank between.
struct Strip {
    int rows = 0, contacts = 0;
    std::vector<double> mass, damping, stiffness, load, normals, tangents, laws, displacement, velocity;
};

Strip read_strip() {
    std::ifstream file(STRIDOR_SOURCE_DIR "/tests/fixtures/structures/strip_s1.txt");
    std::string name;
    Strip strip;
    double omega = 0.0;
    file >> name >> strip.rows >> strip.contacts;
    const auto read = [&](std::vector<double>& numbers, int count) {
        numbers.resize(static_cast<std::size_t>(count));
        for (double& number : numbers)
            file >> number;
    };
    for (std::vector<double>* matrix : {&strip.mass, &strip.damping, &strip.stiffness})
        read(*matrix, strip.rows * strip.rows);
    read(strip.load, strip.rows);
    read(strip.normals, strip.rows * strip.contacts);
    read(strip.tangents, strip.rows * strip.contacts);
    read(strip.laws, 5 * strip.contacts);
    file >> omega;
    read(strip.displacement, strip.rows);
    read(strip.velocity, strip.rows);
    EXPECT_TRUE(static_cast<bool>(file));
    return strip;
}

std::string joined(const std::vector<double>& numbers, std::size_t first, std::size_t step, std::size_t count,
                   const char* between) {
    std::string text;
    char digits[32];
    for (std::size_t k = 0; k < count; ++k) {
        std::snprintf(digits, sizeof digits, "%.17g", numbers[first + k * step]);
        text += (k > 0 ? between : "") + std::string(digits);
    }
    return text;
}

// the strip as a user would bring it: matrices and contacts as CSV beside a case file
std::string strip_case(const Strip& strip, const support::ScratchFolder& folder) {
    const auto rows = static_cast<std::size_t>(strip.rows);
    const auto contacts = static_cast<std::size_t>(strip.contacts);
    for (const auto& [name, matrix] :
         {std::pair("m.csv", &strip.mass), std::pair("c.csv", &strip.damping), std::pair("k.csv", &strip.stiffness)}) {
        std::string text;
        for (std::size_t row = 0; row < rows; ++row)
            text += joined(*matrix, row * rows, 1, rows, ",") + "\n";
        storage::write_file((folder / name).string(), text);
    }
    std::string table = "name;normal;tangent;initial_gap;static_friction;kinetic_friction\n";
    for (std::size_t k = 0; k < contacts; ++k)
        table += "foot" + std::to_string(k + 1) + ";" + joined(strip.normals, k, contacts, rows, " ") + ";" +
                 joined(strip.tangents, k, contacts, rows, " ") + ";" + joined(strip.laws, k, contacts, 3, ";") + "\n";
    storage::write_file((folder / "contacts.csv").string(), table);
    std::vector<double> velocity = strip.velocity;
    for (double& each : velocity)
        each /= strip.laws[3 * contacts];
    const std::string path = (folder / "strip.toml").string();
    storage::write_file(
        path,
        "[structure]\nmass = \"m.csv\"\ndamping = \"c.csv\"\nstiffness = \"k.csv\"\n"
        "contacts = \"contacts.csv\"\nload = [" +
            joined(strip.load, 0, 1, rows, ", ") + "]\ninitial_velocity = [" + joined(velocity, 0, 1, rows, ", ") +
            "]\n[contact]\n[drive]\nkind = \"constant\"\nvelocity = " + joined(strip.laws, 3 * contacts, 1, 1, "") +
            fmt::format("\n[run]\nduration = {}\nwindow = {}\n", support::strip_watched.duration,
                        support::strip_watched.window));
    return path;
}

TEST(OwnStructure, StripOfRubberHasTheMeanSharesOfThePrototype) {
    const Strip strip = read_strip();
    const support::ScratchFolder folder;
    const parameters::Case c = io::read_case(strip_case(strip, folder));
    ASSERT_EQ(c.own_structure->contacts.size(), 5U);
    EXPECT_FALSE(parameters::is_preloaded(c));
    const Motion motion = integration::simulate(c);
    EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
    EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-10);
    double mean[3]{};
    for (const auto& contact : support::shares(motion))
        for (std::size_t state = 0; state < 3; ++state)
            mean[state] += contact[state] / 5.0;
    EXPECT_NEAR(mean[1], 0.8335, support::strip_scatter);
    EXPECT_NEAR(mean[0], 0.1665, support::strip_scatter);
    EXPECT_NEAR(mean[2], 0.0, 1e-4);
}

// --- a lip of rubber, reduced to its edge: nodes that mirror each other, slips that begin and end at one instant

std::string lip_case(const support::ScratchFolder& folder) {
    const reduction::ElasticPart part =
        io::read_part({.files = {STRIDOR_SOURCE_DIR "/tests/fixtures/structures/lip/lip.sti"}});
    const reduction::Reduction reduced =
        craig_bampton(part, {.boundary = reduction::named_rows(part, "EDGE"), .modes = 10});
    io::write_reduced_part((folder / "lip.nc").string(), reduced, "lip.sti");
    return "[structure]\nfile = \"" + (folder / "lip.nc").string() +
           "\"\ndamping_ratio = 0.02\n[[structure.contact]]\nset = \"EDGE\"\nnormal = \"z\"\ntangent = \"x\"\n"
           "[contact]\npreload = 4\nstatic_friction = 0.3\nkinetic_friction = 0.3\n"
           "[drive]\nkind = \"constant\"\nvelocity = 0.1\n[run]\nduration = 0.1\n";
}

TEST(OwnStructure, LipHasForcesWhereItsMirroredNodesSlipTogether) {
    const support::ScratchFolder folder;
    const std::string text = lip_case(folder);
    struct Friction {
        double stick, slip, preload, velocity;
    };
    for (const Friction& each :
         {Friction{0.3, 0.3, 4.0, 0.1}, Friction{0.3, 0.24, 16.0, 0.1}, Friction{0.5, 0.4, 16.0, 0.03},
          Friction{1.1, 0.55, 16.0, 0.1}, Friction{1.1, 1.1, 0.5, 0.1}, Friction{1.1, 1.1, 4.0, 0.1}}) {
        parameters::Case c = io::read_case(io::TomlSource{text, "lip.toml", {}});
        c.contact().static_friction = each.stick;
        c.contact().kinetic_friction = each.slip;
        c.contact().preload = each.preload;
        c.drive.velocity = each.velocity;
        c.run.early_ending = parameters::EarlyEnding::never;
        const Motion motion = integration::simulate(c);
        EXPECT_EQ(motion.outcome.reason, integration::Reason::completed) << each.stick << " " << each.preload;
        EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-10);
    }
}

}  // namespace
}  // namespace stridor
