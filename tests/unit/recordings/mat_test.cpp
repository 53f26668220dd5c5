#include "stridor/recordings/mat/mat.hpp"

#include "signal_support.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "support/expected_error.hpp"
#include "support/needs.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>

namespace stridor::recordings {

using support::error_of;
using support::expect_error;
namespace {

constexpr std::array files{"packed.mat", "plain.mat", "version_4.mat", "version_73.mat"};

// the machine may lack libmatio, and so may the build
bool lacks_matio() {
    try {
        open_signal(fixture("plain.mat"));
    } catch (const Error& error) {
        return error.problem().why.find("libmatio") != std::string::npos;
    }
    return false;
}

#define NEEDS_MATIO() STRIDOR_NEEDS(!lacks_matio(), "libmatio", "libmatio-dev")

std::map<std::string, std::vector<double>> samples_of(const SignalInput& input) {
    const auto file = open_signal(input);
    std::map<std::string, std::vector<double>> samples;
    const std::vector<signal::Channel> channels = file->layout().channels;
    const std::vector<signal::Signal> signals = signal::read_all(*file);
    for (std::size_t k = 0; k < channels.size(); ++k)
        samples[channels[k].name] = signals[k].samples;
    return samples;
}

void append(std::string& bytes, auto number, std::endian order) {
    auto raw = std::bit_cast<std::array<char, sizeof number>>(number);
    if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

// a variable of version 4: a header of five words, its name, its numbers column by column
std::string variable_4(const std::string& name, std::uint32_t rows, const std::vector<double>& numbers,
                       std::endian order = std::endian::little) {
    std::string bytes;
    const auto columns = static_cast<std::uint32_t>(numbers.size()) / rows;
    for (const std::uint32_t word :
         {order == std::endian::big ? 1000U : 0U, rows, columns, 0U, static_cast<std::uint32_t>(name.size() + 1)})
        append(bytes, word, order);
    bytes += name + '\0';
    for (const double number : numbers)
        append(bytes, number, order);
    return bytes;
}

std::vector<double> even_times(std::size_t count, double rate) {
    std::vector<double> times(count);
    for (std::size_t k = 0; k < count; ++k)
        times[k] = static_cast<double>(k) / rate;
    return times;
}

TEST(Mat, OfEveryVersionIsReadToTheBit) {
    NEEDS_MATIO();
    for (const char* name : files) {
        const auto file = open_signal(fixture(name));
        EXPECT_EQ(file->layout().rate, 1000.0) << name;
        EXPECT_EQ(file->layout().frames, 12U) << name;
        EXPECT_EQ(file->layout().channels[0].unit, signal::full_scale) << name;
        const auto samples = samples_of(open_input(fixture(name)));
        ASSERT_EQ(samples.size(), 4U) << name;
        for (std::size_t k = 0; k < 12; ++k) {
            const auto number = static_cast<double>(k);
            EXPECT_EQ(samples.at("force")[k], number / 7.0) << name;
            EXPECT_EQ(samples.at("plate(1)")[k], number) << name;
            EXPECT_EQ(samples.at("plate(2)")[k], number - 0.5) << name;
            EXPECT_EQ(samples.at("counts")[k], k == 0 ? -32768.0 : k == 11 ? 32767.0 : number) << name;
        }
    }
}

TEST(Mat, TakesOneChannelByItsName) {
    NEEDS_MATIO();
    OpenOptions options;
    options.channel_name = "plate(2)";
    const std::vector<signal::Signal> only = all_of(fixture("packed.mat"), options);
    ASSERT_EQ(only.size(), 1U);
    EXPECT_EQ(only[0].samples[11], 10.5);
    options.channel_name = "plate";
    expect_error(error_of([&] { open_signal(fixture("packed.mat"), options); }), "there is no channel \"plate\"",
                 fixture("packed.mat"));
}

TEST(Mat, OfEitherOrderOfBytesIsRead) {
    NEEDS_MATIO();
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        const auto samples = samples_of(
            input_of(variable_4("fs", 1, {8000.0}, order) + variable_4("x", 3, {1.0, -2.0, 1.0 / 3.0}, order)));
        EXPECT_EQ(samples.at("x"), (std::vector<double>{1.0, -2.0, 1.0 / 3.0}));
    }
}

TEST(Mat, TakesItsRateFromEvenTimes) {
    NEEDS_MATIO();
    const std::vector<double> samples(3000, 1.0);
    const auto times = even_times(3000, 51200.0);
    const auto file = open_signal(input_of(variable_4("time", 3000, times) + variable_4("x", 3000, samples)));
    EXPECT_EQ(file->layout().rate, 51200.0);
    EXPECT_EQ(signal::read_all(*file)[0].samples, samples);
}

TEST(Mat, RefusesUnevenTimes) {
    NEEDS_MATIO();
    const std::vector<double> samples(3000, 1.0);
    std::vector<double> times = even_times(3000, 51200.0);
    times[2000] += 0.2 / 51200.0;
    const auto bytes = variable_4("time", 3000, times) + variable_4("x", 3000, samples);
    expect_error(error_of([&] { all_of(input_of(bytes)); }), "the times are not evenly spaced (at 51200 Hz, time(2001)",
                 "f");
    times[5] = times[4];
    const auto still = variable_4("time", 3000, times) + variable_4("x", 3000, samples);
    expect_error(error_of([&] { all_of(input_of(still)); }), "the times do not increase (time(6)", "f");
}

TEST(Mat, SaysWhichSampleIsNotFinite) {
    NEEDS_MATIO();
    const auto bytes = variable_4("fs", 1, {8.0}) + variable_4("x", 3, {1.0, std::nan(""), 1.0});
    expect_error(error_of([&] { all_of(input_of(bytes)); }), "sample 2 of the channel \"x\" is nan", "f");
}

std::vector<double> counted(std::size_t count) {
    std::vector<double> numbers(count);
    for (std::size_t k = 0; k < count; ++k)
        numbers[k] = static_cast<double>(k + 1);
    return numbers;
}

std::vector<double> alternating(std::size_t count) {
    std::vector<double> numbers(count, 0.5);
    for (std::size_t k = 0; k < count; k += 2)
        numbers[k] = -0.5;
    return numbers;
}

TEST(Mat, CountersAndTroubledChannelsAreLeftOut) {
    NEEDS_MATIO();
    std::vector<double> damaged = alternating(100);
    damaged[77] = std::nan("");
    const std::string bytes = variable_4("fs", 1, {4000.0}) + variable_4("n", 100, counted(100)) +
                              variable_4("aux", 100, damaged) + variable_4("acc", 100, alternating(100));
    const auto file = open_signal(input_of(bytes));
    ASSERT_EQ(file->layout().channels.size(), 1U);
    EXPECT_EQ(file->layout().channels[0].name, "acc");
    EXPECT_EQ(signal::read_all(*file)[0].samples, alternating(100));
    EXPECT_EQ(file->facts().notes,
              (std::vector<std::string>{
                  "channel \"n\" was left out: it grows by the same step in every sample, as a counter does",
                  "channel \"aux\" was left out: it is nan in sample 78"}));
    EXPECT_EQ(all_of(input_of(bytes), {.channel_name = "n"})[0].samples, counted(100)) << "it was asked for";
    expect_error(error_of([&] { all_of(input_of(bytes), {.channel_name = "aux"}); }),
                 "sample 78 of the channel \"aux\" is nan", "f");
}

TEST(Mat, ACountedFirstColumnIsNoTime) {
    NEEDS_MATIO();
    std::vector<double> matrix = counted(100);
    const std::vector<double> samples = alternating(100);
    matrix.insert(matrix.end(), samples.begin(), samples.end());
    const std::string bytes = variable_4("data", 100, matrix);
    expect_error(error_of([&] { all_of(input_of(bytes)); }), "data(1) counts in whole steps", "f");
    const auto file = open_signal(input_of(bytes), {.rate = 4000.0});
    EXPECT_EQ(file->layout().channels[0].name, "data(2)");
    EXPECT_EQ(signal::read_all(*file)[0].samples, samples);
}

TEST(Mat, ARateIsHeldAgainstTheTimesAndTheUsersOutranksThem) {
    NEEDS_MATIO();
    const std::string bytes = variable_4("t", 100, even_times(100, 4000.0)) + variable_4("acc", 100, alternating(100));
    expect_error(error_of([&] { open_signal(input_of(variable_4("fs", 1, {8000.0}) + bytes)); }),
                 "the file tells two sampling rates (8000 Hz, and 4000 Hz by the times in t). Say which one it is: "
                 "--rate 8000",
                 "f");
    EXPECT_EQ(open_signal(input_of(variable_4("fs", 1, {4000.0}) + bytes))->layout().rate, 4000.0);
    const auto file = open_signal(input_of(variable_4("fs", 1, {8000.0}) + bytes), {.rate = 8000.0});
    EXPECT_EQ(file->layout().rate, 8000.0);
    EXPECT_EQ(file->facts().notes, (std::vector<std::string>{"the times in t were left out, as --rate tells 8000 Hz"}));
    EXPECT_EQ(signal::read_all(*file)[0].samples, alternating(100));
}

TEST(Mat, ATimeThatGivesNoSoundInSecondsIsTold) {
    NEEDS_MATIO();
    const auto file =
        open_signal(input_of(variable_4("t", 100, even_times(100, 4.0)) + variable_4("acc", 100, alternating(100))));
    EXPECT_EQ(file->facts().notes, (std::vector<std::string>{"t was taken for seconds, which gives 4 Hz; if it is in "
                                                             "milliseconds, say --rate 4000"}));
}

TEST(Mat, ThatClaimsMoreThanItsBytesHoldIsRefused) {
    NEEDS_MATIO();
    std::string bytes = variable_4("fs", 1, {8.0}) + variable_4("x", 3, {1.0, 2.0, 3.0});
    const std::size_t rows = variable_4("fs", 1, {8.0}).size() + 4;
    bytes.replace(rows, 4, std::string("\xff\xff\xff\x0f", 4));
    expect_error(error_of([&] { all_of(input_of(bytes)); }), "the MAT file is damaged", "f");
}

/// Reads what is made of each fixture and so many of its places; all of them by STRIDOR_FUZZ_RUNS=20000.
void read_changed(const std::function<std::string(std::string whole, std::size_t place)>& change,
                  const std::function<void(const std::map<std::string, std::vector<double>>& sound,
                                           const std::map<std::string, std::vector<double>>& found)>& look) {
    const std::uint64_t places = support::runs(60).count;
    for (const char* name : files) {
        const std::string whole = storage::read_file(fixture(name));
        const auto sound = samples_of(input_of(whole));
        for (std::size_t place = 1; place < whole.size(); place += 1 + whole.size() / places) {
            SCOPED_TRACE(name + std::string(", byte ") + std::to_string(place));
            try {
                look(sound, samples_of(input_of(change(whole, place))));
            } catch (const Error& error) {
                EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
                EXPECT_TRUE(error.place()) << error.what();
            }
        }
    }
}

// a variable that is cut off as a whole is missing, no more
TEST(Mat, CutOffIsRefusedOrShortOfVariables) {
    NEEDS_MATIO();
    read_changed([](const std::string& whole, std::size_t place) { return whole.substr(0, place); },
                 [](const auto& sound, const auto& found) {
                     for (const auto& [channel, samples] : found)
                         EXPECT_EQ(samples, sound.at(channel)) << channel;
                 });
}

TEST(Mat, WithAnyByteChangedEndsInSamplesOrAnError) {
    NEEDS_MATIO();
    const auto flip = [](std::string whole, std::size_t place) {
        constexpr std::array<unsigned, 3> changes{0x01, 0x80, 0xFF};
        whole[place] = static_cast<char>(static_cast<unsigned char>(whole[place]) ^ changes[place % changes.size()]);
        return whole;
    };
    read_changed(flip, [](const auto&, const auto& found) { EXPECT_FALSE(found.empty()); });
}

TEST(Mat, CutOffSaysWhereItEnds) {
    NEEDS_MATIO();
    const std::string whole = storage::read_file(fixture("plain.mat"));
    expect_error(error_of([&] { open_signal(input_of(whole.substr(0, whole.size() - 3))); }),
                 "the MAT file is damaged (it is cut off in its variable 4, 3 bytes short)", "f");
    expect_error(error_of([&] { open_signal(input_of(whole.substr(0, 100))); }), "it is cut off in its header", "f");
}

TEST(Mat, IsKnownByItsBeginningAlone) {
    EXPECT_TRUE(is_mat("MATLAB 5.0 MAT-file, Platform: GLNXA64"));
    EXPECT_TRUE(is_mat(variable_4("x", 1, {1.0})));
    EXPECT_TRUE(is_mat(variable_4("x", 1, {1.0}, std::endian::big)));
    EXPECT_FALSE(is_mat(variable_4("x", 1, {1.0}).substr(0, 21)));
    EXPECT_FALSE(is_mat(std::string(200, '\0')));
    EXPECT_FALSE(is_mat("time,force\n0,1\n1,2\n0,1\n1,2\n"));
    for (const char* name : {"scipy_16.wav", "sox.ogg", "phone.m4a", "numpy.csv", "uff58b_big_endian.uff"})
        EXPECT_FALSE(is_mat(storage::read_file(fixture(name)))) << name;
}

}  // namespace
}  // namespace stridor::recordings
