#include "stridor/noise_library/starter_noises.hpp"

#include "stridor/parameters/rules/check.hpp"
#include "support/error_text.hpp"
#include "unit/noise_library/library_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace stridor::noise_library {
namespace {

// The starter library is what it promises: many systems, valid cases, and sounds that differ.

TEST(StarterNoises, AreAtLeastFortyOnTwentySystems) {
    std::set<std::string_view> systems;
    for (const StarterNoise& noise : starter_noises())
        systems.insert(noise.system);
    EXPECT_GE(starter_noises().size(), 40U);
    EXPECT_GE(systems.size(), 20U);
}

TEST(StarterNoises, AreValidCasesUnderNamesOfTheirOwn) {
    std::set<std::string> titles;
    for (const StarterNoise& noise : starter_noises()) {
        EXPECT_TRUE(parameters::findings(noise.c).empty()) << noise.c.title;
        EXPECT_TRUE(titles.insert(noise.c.title).second) << noise.c.title;
        for (const std::string_view words : {noise.parts, noise.materials, noise.operation})
            EXPECT_FALSE(words.empty()) << noise.c.title;
        EXPECT_GE(noise.humidity, 0.0);
        EXPECT_LE(noise.humidity, 100.0);
    }
}

// a name counts within its system, so those of one system stand together
TEST(StarterNoises, StandTogetherBySystem) {
    std::set<std::string_view> done;
    std::string_view current;
    for (const StarterNoise& noise : starter_noises()) {
        if (noise.system == current) continue;
        EXPECT_TRUE(done.insert(noise.system).second) << noise.system;
        current = noise.system;
    }
}

TEST(StarterNoises, HaveASystemUnderSeveralPreloadsAndNothingElseChanged) {
    std::map<double, parameters::Case> seals;
    for (const StarterNoise& noise : starter_noises())
        if (noise.system == "seal") seals[noise.c.contact().preload] = noise.c;
    EXPECT_GE(seals.size(), 5U);
    for (const auto& [preload, c] : seals) {
        EXPECT_EQ(c.contact().kinetic_friction, seals.begin()->second.contact().kinetic_friction);
        EXPECT_EQ(c.drive.velocity, seals.begin()->second.drive.velocity);
    }
}

StarterAdding starter_adding() {
    StarterAdding adding;
    adding.probe = [](const std::filesystem::path&, Entry&) {};
    adding.case_text = [](const parameters::Case& c) { return c.title; };
    return adding;
}

// the run is stopped behind its first noise, and goes on there
TEST_F(LibraryFile, TakesStarterNoisesOnceAndGoesOnAfterAStop) {
    Library library = open();
    const std::size_t all = starter_noises().size();
    std::stop_source source;
    StarterAdding first = starter_adding();
    first.stop = source.get_token();
    first.added = [&](const Entry&) { source.request_stop(); };
    const Added stopped = add_starter(library, first);
    EXPECT_EQ(support::thrown_by([&] { std::rethrow_exception(stopped.ended_by); }).kind, ErrorKind::interrupted);
    EXPECT_EQ(stopped.arrivals.added.size(), 1U);
    EXPECT_EQ(stopped.arrivals.left, all - 1);
    const Entry entry = library.get(stopped.arrivals.added).front();
    EXPECT_EQ(entry.recorded, "simulation");
    EXPECT_EQ(entry.case_text, starter_noises().front().c.title);

    source = {};
    first.stop = source.get_token();
    const Added again = add_starter(library, first);
    EXPECT_EQ(again.arrivals.known.size(), 1U);
    EXPECT_EQ(again.arrivals.added.size(), 1U);
}

}  // namespace
}  // namespace stridor::noise_library
