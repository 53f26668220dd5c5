#include "stridor/recordings/mat/mat_choice.hpp"

#include "support/expected_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace stridor::recordings::mat {
namespace {

using support::error_of;
using support::expect_error;

Variable single(const std::string& name, double value) {
    return {name, MatKind::doubles, 1, 1, value};
}

Variable matrix(const std::string& name, std::uint64_t rows, std::uint64_t columns) {
    return {name, MatKind::doubles, rows, columns, 0.0};
}

std::vector<std::string> names_of(const MatChoice& choice) {
    std::vector<std::string> names;
    for (const signal::Channel& channel : choice.channels)
        names.push_back(channel.name);
    return names;
}

using Names = std::vector<std::string>;

TEST(MatChoice, TakesEveryVectorAndColumnOfOneLength) {
    const MatChoice choice = choose(
        {single("Fs", 48000.0), matrix("force", 100, 1), matrix("data", 2, 100), single("temperature", 23.5)}, {}, "f");
    EXPECT_EQ(names_of(choice), (Names{"force", "data(1)", "data(2)"}));
    EXPECT_EQ(choice.frames, 100U);
    EXPECT_EQ(choice.rate, 48000.0);
    EXPECT_FALSE(choice.time);
    EXPECT_EQ(choice.columns, (std::vector<MatColumn>{{1, 0, 0}, {2, 0, 1}, {2, 1, 1}}));
    ASSERT_EQ(choice.metadata.size(), 1U);
    EXPECT_EQ(choice.metadata[0].first, "temperature");
    EXPECT_EQ(choice.metadata[0].second, "23.5");
}

TEST(MatChoice, KnowsTheUsualNamesOfRates) {
    for (const char* name : {"fs", "FS", "sr", "sample_rate", "SampleRate", "fsamp", "sampling_frequency"})
        EXPECT_EQ(choose({single(name, 44100.0), matrix("x", 5, 1)}, {}, "f").rate, 44100.0) << name;
    EXPECT_EQ(choose({single("dt", 1.0 / 48000.0), matrix("x", 5, 1)}, {}, "f").rate, 48000.0) << "one over the step";
    EXPECT_EQ(choose({single("Fs", 1.0), single("dt", 7.0), matrix("x", 5, 1)}, {}, "f").rate, 1.0)
        << "a rate needs no inverse";
    EXPECT_EQ(choose({single("fs", 1.0), single("sr", 2.0), matrix("x", 5, 1)}, {.rate = 3.0}, "f").rate, 3.0)
        << "the user knows better";
}

TEST(MatChoice, RefusesRatesThatAreNoneOrTwo) {
    for (const double rate : {0.0, -1.0, 1e300, std::nan("")})
        expect_error(error_of([&] {
                         choose({single("fs", rate), matrix("x", 5, 1)}, {}, "f");
                     }),
                     "gives no sampling rate", "f");
    expect_error(error_of([] {
                     choose({single("fs", 1.0), single("sr", 2.0), matrix("x", 5, 1)}, {}, "f");
                 }),
                 "tells two sampling rates", "f");
    expect_error(error_of([] {
                     choose({matrix("x", 5, 1), matrix("y", 5, 1)}, {}, "f");
                 }),
                 "does not tell its sampling rate", "f");
}

TEST(MatChoice, TakesWhatIsAsLongAsTheTimes) {
    const MatChoice choice =
        choose({matrix("t", 1, 100), matrix("x", 100, 1), matrix("gains", 1, 3), matrix("y", 100, 200)},
               {.rate = {}, .channel = "x"}, "f");
    EXPECT_EQ(choice.columns.size(), 201U) << "y has 200 columns: the times say which side is time";
    EXPECT_EQ(choice.time, (MatColumn{0, 0, 1}));
    EXPECT_EQ(choice.notes, (Names{"left out: gains (1 x 3)"}));
    EXPECT_FALSE(choice.rate) << "the times tell it";
    expect_error(error_of([] {
                     choose({matrix("t", 100, 1), matrix("x", 99, 1)}, {}, "f");
                 }),
                 "t has 100 numbers; there are x (99 x 1)", "f");
}

TEST(MatChoice, TakesTheFirstColumnForTheTimeWhereNothingElseTellsIt) {
    const MatChoice choice = choose({matrix("data", 100, 3)}, {}, "f");
    EXPECT_EQ(names_of(choice), (Names{"data(2)", "data(3)"}));
    EXPECT_EQ(choice.time, (MatColumn{0, 0, 0}));
    EXPECT_EQ(choice.notes, (Names{"data(1) was taken for the time in seconds"}));
    EXPECT_FALSE(choose({matrix("data", 100, 3), single("fs", 1.0)}, {}, "f").time);
}

TEST(MatChoice, AsksWhichOfSeveralLengthsAndTakesIt) {
    const std::vector<Variable> variables{single("fs", 10.0), matrix("force", 100, 1), matrix("data", 50, 2)};
    const auto error = error_of([&] { choose(variables, {}, "f"); });
    expect_error(error, "the variables differ in length (force (100 x 1), data (50 x 2))", "f");
    EXPECT_NE(error->problem().suggestion.find("--channel NAME"), std::string::npos);
    EXPECT_EQ(names_of(choose(variables, {.rate = {}, .channel = "force"}, "f")), Names{"force"});
    EXPECT_EQ(names_of(choose(variables, {.rate = {}, .channel = "data(2)"}, "f")), (Names{"data(1)", "data(2)"}));
}

TEST(MatChoice, SaysWhatThereIsWhereNothingIsASignal) {
    const std::vector<Variable> variables{single("fs", 10.0),
                                          {"s", MatKind::structure, 1, 1, 0.0},
                                          {"z", MatKind::complex, 9, 1, 0.0},
                                          {"c", MatKind::text, 1, 5, 0.0}};
    expect_error(error_of([&] { choose(variables, {}, "f"); }),
                 "fs (1 x 1), s (a structure), z (complex numbers), c (text)", "f");
    expect_error(error_of([] { choose({}, {}, "f"); }), "no variables", "f");
    expect_error(error_of([] {
                     choose({matrix("x", 300, 257), single("fs", 1.0)}, {}, "f");
                 }),
                 "more than 256 channels", "f");
}

}  // namespace
}  // namespace stridor::recordings::mat
