#include "stridor/io/simulation/end_state_file.hpp"

#include "io_support.hpp"
#include "stridor/base/error.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/joints.hpp"
#include "support/constant_case.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace stridor::io {
namespace {

using parameters::Case;
using support::short_case;
using support::thrown_by;

const std::string& document() {
    static const std::string text = end_state_json(short_case(), integration::run_to_end(short_case()).state);
    return text;
}

TEST(EndStateFile, ReadsBackBitForBit) {
    const integration::EndState state = integration::run_to_end(short_case()).state;
    const ReadEndState read = read_end_state(end_state_json(short_case(), state), "end.json");
    EXPECT_EQ(read.state.time, state.time);
    EXPECT_EQ(read.state.displacement, state.displacement);
    EXPECT_EQ(read.state.velocity, state.velocity);
    EXPECT_EQ(read.state.contacts, state.contacts);
    EXPECT_EQ(read.state.memory, state.memory);
    EXPECT_NO_THROW(expect_same_case(read, short_case(), "end.json"));
}

// where rest changes nothing a file has none, as it had before
TEST(EndStateFile, KeepsTheTimeOfRestWhereFrictionGrowsWithIt) {
    EXPECT_EQ(document().find("rested"), std::string::npos);
    integration::EndState state = integration::run_to_end(short_case()).state;
    state.rested = {0.125};
    const std::string text = end_state_json(short_case(), state);
    EXPECT_EQ(read_end_state(text, "end.json").state.rested, state.rested);
    const std::string forged = replaced(text, "0.125", "0.25");
    EXPECT_TRUE(thrown_by([&] { read_end_state(forged, "end.json"); }).says("its checksum is another"));
    for (const std::vector<double>& odd : {std::vector{0.1, 0.2}, std::vector{-1.0}}) {
        state.rested = odd;
        EXPECT_TRUE(thrown_by([&] {
                        read_end_state(end_state_json(short_case(), state), "end.json");
                    }).says("rested is no time for each contact"));
    }
}

TEST(EndStateFile, IsOfACaseWhateverItsDurationAndThresholds) {
    const ReadEndState read = read_end_state(document(), "end.json");
    Case c = short_case();
    c.run.duration = 1.0;
    c.run.window = 0.5;
    c.verdict.quiet_slip = 0.9;
    EXPECT_NO_THROW(expect_same_case(read, c, "end.json"));
    c.contact().preload = 30.0;
    const auto thrown = thrown_by([&] { expect_same_case(read, c, "end.json"); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("of another case") && thrown.says("--initial") && thrown.says("end.json"))
        << thrown.message;
    EXPECT_NO_THROW(expect_same_shape(read, c, "end.json"));
    EXPECT_TRUE(thrown_by([&] {
                    expect_same_shape(read, parameters::two_lips(), "end.json");
                }).says("3 degrees of freedom and 1 contact, the case 5 degrees of freedom and 2 contacts"));
}

TEST(EndStateFile, NoticesEachDamagedByteOfWhatCounts) {
    const std::string whole = document();
    for (std::size_t at = whole.find("\"case\""); at < whole.find("\"units\""); at += 7) {
        std::string damaged = whole;
        damaged[at] = damaged[at] == '1' ? '2' : '1';
        try {
            const ReadEndState read = read_end_state(damaged, "end.json");
            // a blank between values, or an equal number
            EXPECT_EQ(read.state.memory, read_end_state(whole, "end.json").state.memory) << at;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::input) << at;
        }
    }
}

TEST(EndStateFile, RefusesWhatIsNone) {
    const auto refused = [](const std::string& text) {
        const auto thrown = thrown_by([&] { read_end_state(text, "end.json"); });
        return thrown.kind == ErrorKind::input && thrown.says("no end state");
    };
    EXPECT_TRUE(refused(""));
    EXPECT_TRUE(refused("{"));
    EXPECT_TRUE(refused("[]"));
    EXPECT_TRUE(refused("{}"));
    EXPECT_TRUE(refused(std::string(1000, '[')));
    EXPECT_TRUE(refused("{\"schema\": \"stridor.end-state/2\"}"));
    EXPECT_TRUE(refused("{\"schema\": \"stridor.end-state/1\"}"));
    std::string endless = document();
    endless.replace(endless.find("\"time\": 0.02"), 12, "\"time\": 1e99");
    EXPECT_TRUE(refused(endless));
}

// of joints in their keys; the phase of the drive goes on
TEST(EndState, IsAGivenStart) {
    Case c = short_case();
    c.drive.kind = parameters::DriveKind::sinusoidal;
    c.drive.frequency = 20.0;
    integration::EndState state = integration::run_to_end(c).state;
    const Case begun = integration::begun_at(c, state);
    EXPECT_EQ(begun.run.initial, parameters::Initial::given);
    EXPECT_EQ(begun.joints[0].start.tangential, state.displacement[0]);
    EXPECT_EQ(begun.plate.initial_normal, state.displacement[2]);
    EXPECT_NEAR(begun.drive.phase, 144.0, 1e-9);  // 0.4 of a period
    // the same turns, the other way to count them
    EXPECT_NE(parameters::canonical_text(begun).find("drive.phase = "), std::string::npos);
    EXPECT_EQ(parameters::canonical_text(c).find("drive.phase"), std::string::npos);
}

}  // namespace
}  // namespace stridor::io
