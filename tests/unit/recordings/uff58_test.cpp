#include "stridor/recordings/uff58/uff58.hpp"

#include "signal_support.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "support/counter_random.hpp"
#include "support/expected_error.hpp"
#include "support/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace stridor::recordings {

using support::error_of;
using support::expect_error;
using support::replaced;
using support::ScratchFolder;
namespace {

using signal::Signal;

constexpr int uff58_frames = 64;

double ramp(int k) {
    return (k - 32) * 0.25;
}

TEST(Uff58, ReadsDExponents) {
    const auto file = open_signal(fixture("uff58_d_exponents.uff"));
    EXPECT_EQ(file->layout().rate, 48000.0);
    EXPECT_EQ(file->facts().notes, (std::vector<std::string>{"the step 2.08333e-05 s was taken for 48000 Hz"}));
    const std::vector<Signal> found = signal::read_all(*file);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].unit, "m/s^2");
    ASSERT_EQ(found[0].samples.size(), 64U);
    for (int k = 0; k < uff58_frames; ++k)
        EXPECT_EQ(found[0].samples[static_cast<std::size_t>(k)], ramp(k));
}

TEST(Uff58, ReadsAHeaderOfOddWidthAndNumbersThatTouch) {
    const std::vector<Signal> found = all_of(fixture("uff58_odd_width.uff"));
    EXPECT_EQ(found[0].rate, 51200.0);
    EXPECT_EQ(found[0].unit, "m/s^2");
    for (int k = 0; k < uff58_frames; ++k)
        EXPECT_EQ(found[0].samples[static_cast<std::size_t>(k)], (-1000.0 - ramp(k)) * 9.80665);
}

TEST(Uff58, ReadsBigEndianChannelsAmongOtherDatasets) {
    const auto file = open_signal(fixture("uff58b_big_endian.uff"));
    EXPECT_EQ(file->layout().rate, 44100.0);
    EXPECT_EQ(file->layout().channels[1].name, "second");
    const std::vector<Signal> found = signal::read_all(*file);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[1].unit, "m/s");
    for (int k = 0; k < uff58_frames; ++k)
        EXPECT_EQ(found[1].samples[static_cast<std::size_t>(k)], -ramp(k) * 1e-3);
}

// front ends write labels of their own
std::string history_of(const char* time, const char* unit) {
    std::string text = "    -1\n    58\nv2;100\nRUN-01\n24-03-11\nunit 1\nNacDir;deg\n";
    text += "    1         1    0         0 AP                 1   3 NONE               0   0\n";
    text += "         2         4         1  0.00000E+00  1.00000E+00  0.00000E+00\n";
    for (const auto& [code, name, label] :
         {std::tuple{17, "Time", time}, {12, "Acceleration", unit}, {0, "NONE", "NONE"}, {0, "NONE", "NONE"}})
        text += fmt::format("{:10d}    0    0    0 {:<21}{:<20}\n", code, name, label);
    return text + "  0.00000E+00  1.50000E+00 -2.00000E+00  1.00000E+00\n    -1\n";
}

TEST(Uff58, KnowsUnitsAsFrontEndsWriteThem) {
    const std::vector<Signal> found = all_of(input_of(history_of("ms", "m/s2")));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].rate, 1000.0);
    EXPECT_EQ(found[0].unit, "m/s^2");
    EXPECT_EQ(found[0].samples, (std::vector<double>{0.0, 1.5, -2.0, 1.0}));
    EXPECT_EQ(all_of(input_of(history_of("NONE", "(m/s^2)")))[0].rate, 1.0);
    EXPECT_EQ(all_of(input_of(history_of("sec", "mm/s2")))[0].samples[1], 1.5e-3);
    expect_error(error_of([] { all_of(input_of(history_of("ticks", "g"), "f.uff")); }),
                 "the time is in \"ticks\" (that is no unit of time", "f.uff:10");
}

Signal uff58_noise(double rate, const std::string& unit, std::uint64_t seed) {
    support::CounterRandom random(seed);
    Signal signal{rate, unit, {}};
    for (int k = 0; k < 20001; ++k)
        signal.samples.push_back(random.between(-1.0, 1.0) * random.decades(1e-8, 1e8));
    return signal;
}

TEST(WriteUff58, GivesBackEveryBitInItsBinaryForm) {
    const ScratchFolder scratch;
    for (const double rate : {44100.0, 51200.0, 48000.5, 1000.0 / 3.0}) {
        const Signal a = uff58_noise(rate, "m/s^2", 1), b = uff58_noise(rate, "FS", 2);
        EXPECT_EQ(write_uff58((scratch / "a.uff").string(), *signal::source_of({a, b}), Uff58Form::binary), 20001U);
        const auto file = open_signal((scratch / "a.uff").string());
        EXPECT_EQ(file->facts().notes.size(), 0U);
        const std::vector<Signal> back = signal::read_all(*file);
        ASSERT_EQ(back.size(), 2U);
        EXPECT_EQ(back[0].rate, rate);
        EXPECT_EQ(back[0].unit, "m/s^2");
        EXPECT_EQ(back[0].samples, a.samples);
        EXPECT_EQ(back[1].unit, "FS");
        EXPECT_EQ(back[1].samples, b.samples);
    }
}

TEST(WriteUff58, GivesBackThirteenDigitsInItsAsciiForm) {
    const ScratchFolder scratch;
    const Signal a = uff58_noise(44100.0, "Pa", 1);
    write_uff58((scratch / "a.uff").string(), *signal::source_of({a}), Uff58Form::ascii);
    const std::vector<Signal> back = all_of((scratch / "a.uff").string());
    EXPECT_EQ(back[0].rate, 44100.0);
    ASSERT_EQ(back[0].samples.size(), a.samples.size());
    for (std::size_t k = 0; k < a.samples.size(); ++k)
        ASSERT_NEAR(back[0].samples[k], a.samples[k], 0.51e-12 * std::abs(a.samples[k]));
}

TEST(WriteUff58, KeepsToTheColumnsOfItsCards) {
    const ScratchFolder scratch;
    write_uff58((scratch / "a.uff").string(),
                *signal::source_of({Signal{48000.0, "Pa", {1.0, -1e-300, 2.0, 3.0, 4.0}}}), Uff58Form::ascii);
    const std::string text = storage::read_file((scratch / "a.uff").string());
    EXPECT_TRUE(text.starts_with("    -1\n    58\n"));
    EXPECT_TRUE(text.ends_with("\n    -1\n"));
    EXPECT_NE(text.find("\n         4         5         1  0.00000E+00  2.08333E-05  0.00000E+00\n"),
              std::string::npos);
    EXPECT_NE(text.find("\n  1.000000000000E+00-1.000000000000E-300  2.000000000000E+00"), std::string::npos) << text;
}

std::string written(const Signal& signal, Uff58Form form) {
    const ScratchFolder scratch;
    write_uff58((scratch / "a.uff").string(), *signal::source_of({signal}), form);
    return storage::read_file((scratch / "a.uff").string());
}

TEST(Uff58, LetsTheUserChooseAmongHistoriesThatDiffer) {
    const std::string both = written({48000.0, "N", {1.0, 2.0}}, Uff58Form::ascii) +
                             written({100.0, "m", {3.0, 4.0, 5.0}}, Uff58Form::binary);
    expect_error(error_of([&] { open_signal(input_of(both)); }), "1: 2 values at 48000 Hz, 2: 3 values at 100 Hz", "f");
    OpenOptions options;
    options.dataset = 2;
    EXPECT_EQ(all_of(input_of(both), options)[0].samples, (std::vector<double>{3.0, 4.0, 5.0}));
    options.dataset = 3;
    EXPECT_TRUE(error_of([&] { open_signal(input_of(both), options); }));
}

TEST(Uff58, RefusesWhatItCannotRead) {
    const std::string ascii = written({48000.0, "N", {1.0, 2.0, 3.0, 4.0, 5.0}}, Uff58Form::ascii);
    const std::string binary = written({48000.0, "N", {1.0, 2.0}}, Uff58Form::binary);
    const auto refusal = [](const std::string& text) { return error_of([&] { all_of(input_of(text, "d.uff")); }); };
    expect_error(refusal(replaced(ascii, "         5         1", "         5         0")), "uneven step", "d.uff:9");
    expect_error(refusal(replaced(ascii, "         4         5", "         6         5")), "data of type 6", "d.uff:9");
    expect_error(refusal(replaced(ascii, "         5         1", "         0         1")), "holds no values",
                 "d.uff:9");
    const std::string cut = replaced(ascii, "         5         1", "         6         1");
    expect_error(refusal(cut.substr(0, cut.rfind("    -1"))), "it ends after 5 of 6 values, without a mark",
                 "d.uff:15");
    expect_error(refusal(replaced(ascii, "2.08333E-05", "0.00000E+00")), "is no step", "d.uff:9");
    expect_error(refusal(replaced(ascii, "2.000000000000E+00", "2.0OOOOOOOOOOOE+00")), "is not a number",
                 "d.uff:14:21");
    expect_error(refusal(ascii.substr(0, 300)), "the header of dataset 58 is cut off", "d.uff:6");
    const std::string many = replaced(binary, "         2         1", "3000000000         1");
    expect_error(refusal(many.substr(0, many.rfind("    -1"))), "is cut off", "d.uff:14");
    expect_error(refusal(ascii.substr(0, ascii.rfind("  1.0")) + "    -1\n"), "the time history holds no values",
                 "d.uff:14");
    expect_error(refusal(replaced(binary, "58b     1     2", "58b     3     2")), "unknown byte order", "d.uff:2:1");
    expect_error(refusal(replaced(binary, "58b     1     2", "58b     1     1")), "VMS or IBM", "d.uff:2:1");
    expect_error(refusal("    -1\n   151\nx\n    -1\n"), "holds no time history", "d.uff");
}

// cards of a front end, and four values a line
std::string front_end_history(const std::vector<double>& values, std::size_t count, const std::string& opening,
                              const std::string& unit = "s") {
    std::string text = history_of(unit.c_str(), "m/s2");
    text = replaced(text.substr(0, text.find("  0.00000E+00  1.5")), "         4         1",
                    fmt::format("{:10d}         1", count));
    text = replaced(text, "    58\n", "    58" + opening + "\n");
    if (opening.empty()) {
        for (std::size_t k = 0; k < values.size(); ++k)
            text += fmt::format("{:13.5E}{}", values[k], k % 4 == 3 || k + 1 == values.size() ? "\n" : "");
    } else {
        for (const double value : values) {
            const auto single = static_cast<float>(value);
            text.append(reinterpret_cast<const char*>(&single), sizeof single);
        }
    }
    return text + "    -1\n";
}

std::string little_endian_opening(std::size_t bytes) {
    return fmt::format("b     1     2          11{:12d}     0     0           0           0", bytes);
}

const std::vector<double> ten_values{0.5, -1.5, 2.5, -3.5, 4.5, -5.5, 6.5, -7.5, 8.5, -9.5};

TEST(Uff58, ReadsTheValuesThatAreThereWhateverItsHeaderCounts) {
    for (const std::string& opening : {std::string(), little_endian_opening(40)})
        for (const std::size_t count : {7U, 9U, 3U, 11U, 13U, 4000U}) {
            const auto file = open_signal(input_of(front_end_history(ten_values, count, opening)));
            EXPECT_EQ(signal::read_all(*file)[0].samples, ten_values) << count << opening;
            ASSERT_EQ(file->facts().notes.size(), 1U) << count << opening;
            EXPECT_EQ(file->facts().notes[0], fmt::format("time history 1: the header speaks of {} values, the 10 that "
                                                          "are there were read",
                                                          count));
        }
    // zeros behind the last value fill its line
    const auto filled = open_signal(input_of(front_end_history({1.0, 2.0, 3.0, 4.0, 5.0, 0.0, 0.0}, 5, "")));
    EXPECT_EQ(signal::read_all(*filled)[0].samples.size(), 5U);
    EXPECT_TRUE(filled->facts().notes.empty());
}

TEST(Uff58, BelievesANumberOfBytesOnlyIfAMarkStandsBehindThem) {
    for (const std::size_t bytes : {80U, 20U, 17U, 0U, 100000U}) {
        const std::string first = front_end_history(ten_values, 10, little_endian_opening(bytes));
        const auto file = open_signal(input_of(first + front_end_history(ten_values, 10, little_endian_opening(40))));
        const std::vector<Signal> found = signal::read_all(*file);
        ASSERT_EQ(found.size(), 2U) << bytes;
        EXPECT_EQ(found[0].samples, ten_values) << bytes;
        EXPECT_EQ(found[1].samples, ten_values) << bytes;
    }
}

TEST(Uff58, KnowsSecondsInLargeLetters) {
    for (const char* unit : {"S", "SEC", "mS", "MS", "mSec"})
        EXPECT_EQ(open_signal(input_of(front_end_history(ten_values, 10, "", unit)))->layout().rate,
                  unit == std::string("S") || unit == std::string("SEC") ? 1.0 : 1000.0)
            << unit;
}

TEST(Uff58, WithATroubledChannelIsReadWithoutIt) {
    std::vector<double> overloaded = ten_values;
    overloaded[6] = 9.9e37;
    const std::string bytes = front_end_history(ten_values, 10, "") +
                              replaced(front_end_history(overloaded, 10, ""), "v2;100", "broken") +
                              replaced(front_end_history(ten_values, 10, ""), "v2;100", "third");
    const auto file = open_signal(input_of(bytes));
    ASSERT_EQ(file->layout().channels.size(), 2U);
    EXPECT_EQ(file->layout().channels[1].name, "third");
    EXPECT_EQ(file->facts().notes,
              (std::vector<std::string>{"channel \"broken\" was left out: it is 9.9e+37 in sample 7"}));
    EXPECT_EQ(file->facts().left_out, (std::vector<std::string>{"channel \"broken\": is 9.9e+37 in sample 7"}));
    EXPECT_EQ(signal::read_all(*file)[1].samples, ten_values);
    EXPECT_EQ(all_of(input_of(bytes), {.channel_name = "2"})[0].samples, ten_values) << "what is left is counted";
    expect_error(error_of([&] { all_of(input_of(bytes), {.channel_name = "broken"}); }),
                 "sample 7 of the channel \"broken\" is 9.9e+37", "f");
    const std::vector<FullScale> scales{{2.0, "Pa"}, {3.0, "Pa"}};
    EXPECT_EQ(all_of(input_of(bytes), {.full_scales = scales})[1].samples[0], 1.5) << "one for each that is left";
    const std::vector<FullScale> of_file{{2.0, "Pa"}, {9.0, "Pa"}, {3.0, "Pa"}};
    EXPECT_EQ(all_of(input_of(bytes), {.full_scales = of_file})[1].samples[0], 1.5) << "or in the file";
}

TEST(Uff58, ForgivesAWrongNumberOfBytesWhereTheValuesEndWell) {
    const std::string binary = written({48000.0, "N", {1.0, 2.0}}, Uff58Form::binary);
    EXPECT_EQ(all_of(input_of(replaced(binary, "          16", "           2")))[0].samples,
              (std::vector<double>{1.0, 2.0}));
}

}  // namespace
}  // namespace stridor::recordings
