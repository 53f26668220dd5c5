// Files after public reports of other readers (docs/formats/reports.md): their right values are known.

#include "signal_support.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "stridor/recordings/table/sampled_csv.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "support/expected_error.hpp"
#include "support/needs.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace stridor::recordings {

using support::error_of;
using support::expect_error;
namespace {

using Names = std::vector<std::string>;

double tone_at(int k) {
    return 0.5 * std::sin(2.0 * std::numbers::pi * 0.05 * k);
}

std::string reported_rows(int count, const std::function<std::string(int)>& line) {
    std::string text;
    for (int k = 0; k < count; ++k)
        text += line(k) + "\n";
    return text;
}

std::unique_ptr<SignalFile> reported_table(const std::string& text, const OpenOptions& options = {}) {
    return open_signal(input_of(text, "d.csv"), options);
}

Names shown_channels(const SignalFile& file) {
    Names names;
    for (const signal::Channel& channel : file.layout().channels)
        names.push_back(channel.name + " " + channel.unit);
    return names;
}

std::optional<Error> refusal_of_table(const std::string& text) {
    return error_of([&] { all_of(input_of(text, "d.csv")); });
}

// numpy.savetxt puts its mark before them, Klipper without a blank, COMSOL writes a percent sign
TEST(CommentedNames, AreThoseOfTheColumns) {
    const auto row = [](const char* mark) {
        return [mark](int k) { return fmt::format("{:.5f}{}{:.6f}", 0.00025 * k, mark, tone_at(k)); };
    };
    for (const auto& [head, mark] : {std::pair("# time [s],force [N]\n", ","), std::pair("#time (s),force (N)\n", ","),
                                     std::pair("# model.mph\n# Time (s)   force (N)\n", "   "),
                                     std::pair("% Model: seal\n% Time (s)   force (N)\n", "   "),
                                     std::pair("# time [s];force [N]\n# made by a rig\n\n", ";")}) {
        const auto file = reported_table(head + reported_rows(100, row(mark)));
        EXPECT_EQ(shown_channels(*file), Names{"force N"}) << head;
        EXPECT_EQ(file->layout().rate, 4000.0) << head;
    }
    EXPECT_EQ(shown_channels(*reported_table("# time,force\n" + reported_rows(100, row(",")))), Names{"force FS"});
}

TEST(CommentedNames, AreNoNamesWhereTheTableHasItsOwn) {
    const std::string rows =
        reported_rows(100, [](int k) { return fmt::format("{:.5f},{:.6f}", 0.00025 * k, tone_at(k)); });
    EXPECT_EQ(shown_channels(*reported_table("# time [s],force [N]\nt [s],acc [m/s2]\n" + rows)), Names{"acc m/s^2"});
    EXPECT_EQ(shown_channels(*reported_table("# measured by Smith, Berlin\n" + rows)), Names{" FS"});
    EXPECT_EQ(shown_channels(*reported_table("# rate: 4000 Hz\n" + rows)), Names{" FS"}) << "a fact is no name";
}

TEST(Units, StandBehindASlashToo) {
    const auto file = reported_table("Zeit t / s;Spannung U_B1 / V;Weg / mm\n" + reported_rows(50, [](int k) {
                                         std::string text =
                                             fmt::format("{:.1f};{:.3f};{:.3f}", 0.1 * k, tone_at(k), tone_at(k + 3));
                                         std::replace(text.begin(), text.end(), '.', ',');
                                         return text;
                                     }));
    EXPECT_EQ(file->layout().rate, 10.0);
    EXPECT_EQ(shown_channels(*file), (Names{"Spannung U_B1 V", "Weg m"}));
    EXPECT_EQ(file->facts().units_in_file, (Names{"V", "mm"}));
    EXPECT_EQ(file->facts().time, "column 1, \"Zeit t\" in s");
    // a quotient is no title, and a word behind a slash no unit
    EXPECT_EQ(shown_channels(*reported_table(
                  "time [s],left / right\n" +
                  reported_rows(50, [](int k) { return fmt::format("{:.1f},{:.3f}", 0.1 * k, tone_at(k)); }))),
              Names{"left / right FS"});
}

TEST(Units, InARowOfBracketsAreUnits) {
    const auto file =
        reported_table("Data1\nTime\tACC1/AI A-1\tFORCE\n[s]\t[m/s2]\t[N]\n" + reported_rows(50, [](int k) {
                           return fmt::format("{:.1f}\t{:.3f}\t{:.3f}", 0.1 * k, tone_at(k), tone_at(k + 3));
                       }));
    EXPECT_EQ(shown_channels(*file), (Names{"ACC1/AI A-1 m/s^2", "FORCE N"}));
}

TEST(Units, OfATimeMayBeLarge) {
    const std::string text =
        ";Scopy version,4a0b1ce\n;Sample rate,4000\nSample,Time(S),CH1(V)\n" +
        reported_rows(100, [](int k) { return fmt::format("{},{:.6f},{:.6f}", k, 0.00025 * k, tone_at(k)); });
    const auto file = reported_table(text);
    EXPECT_EQ(file->layout().rate, 4000.0);
    EXPECT_EQ(shown_channels(*file), Names{"CH1 V"});
    expect_error(error_of([&] { reported_table(";Sample rate,48000" + text.substr(text.find("\nSample,"))); }),
                 "the table contradicts itself", "d.csv:3");
}

TEST(Numbers, MayHaveMarksBetweenThousands) {
    const auto of_last = [](const std::string& numeral, char mark) {
        std::string text = "# rate: 2 Hz\nKraft [N];n\n1;2\n3;4\n" + numeral + ";7\n";
        std::replace(text.begin(), text.end(), ';', mark);
        return all_of(input_of(text, "d.csv"), {.channel_name = "Kraft"})[0].samples.back();
    };
    EXPECT_EQ(of_last("1.500,25", ';'), 1500.25);
    EXPECT_EQ(of_last("-12.345.678,5", '\t'), -12345678.5);
    EXPECT_EQ(of_last("1,500.25", ';'), 1500.25);
    EXPECT_EQ(of_last("\"1,500.25\"", ','), 1500.25);
    for (const char* wrong : {"1.50,25", "1.5000,25", ".500,25", "1.500,25,1", "1234.500,25"})
        expect_error(error_of([&] { of_last(wrong, ';'); }), "is not a number", "d.csv:5:1");
}

// what may be 48 kHz or 48 Hz tells nothing
TEST(Numbers, ThatMayBeThousandsAreNoRate) {
    const std::string rows = "acc [m/s2]\n0.5\n-0.5\n0.25\n";
    expect_error(refusal_of_table("Sampling rate: 48,000 Hz\noperator: Smith\n" + rows),
                 "does not tell its sampling rate", "d.csv:4");
    EXPECT_EQ(reported_table("Sampling rate: 48000,5 Hz\noperator: Smith\n" + rows)->layout().rate, 48000.5);
}

// printed with too few digits, backwards, or by a clock that jumps: the way out of each refusal works
TEST(Times, ThatAreWrongGiveWayToARate) {
    const std::string few =
        reported_rows(100, [](int k) { return fmt::format("{:.4g},{:.6f}", 0.0104 + 1e-8 * k, tone_at(k)); });
    const std::string back =
        reported_rows(100, [](int k) { return fmt::format("{:.4f},{:.6f}", 2.0 - 0.004 * k, tone_at(k)); });
    const std::string jumps = reported_rows(
        100, [](int k) { return fmt::format("{:.4f},{:.6f}", 0.001 * k + (k % 7 == 3 ? 4e-4 : 0.0), tone_at(k)); });
    for (const std::string& each : {few, back}) {
        const auto error = refusal_of_table("time [s],acc [m/s2]\n" + each);
        expect_error(error, "the times do not increase", "d.csv:3:1");
        EXPECT_NE(error->problem().suggestion.find("--rate"), std::string::npos);
    }
    expect_error(refusal_of_table("time [s],acc [m/s2]\n" + jumps), "--rate 1000", "d.csv:5:1");
    for (const std::string& each : {few, back, jumps}) {
        const auto file = reported_table("time [s],acc [m/s2]\n" + each, {.rate = 1000.0});
        EXPECT_EQ(signal::read_all(*file)[0].samples.size(), 100U);
        EXPECT_EQ(shown_channels(*file), Names{"acc m/s^2"});
        ASSERT_EQ(file->facts().notes.size(), 1U);
        EXPECT_NE(file->facts().notes[0].find("left out, as --rate tells 1000 Hz"), std::string::npos);
    }
}

TEST(Tables, ThatAreCutShortAreRefusedWithAWayOut) {
    expect_error(refusal_of_table("Timestamp,X,Y,Z\n0.002\n0.023\n"), "Give every row as many fields", "d.csv:2:1");
    const std::string duet = "Sample,X,Y\n" +
                             reported_rows(50, [](int k) { return fmt::format("{},{:.4f},0.1", k, tone_at(k)); }) +
                             "Rate 935, overflows 0\n";
    expect_error(refusal_of_table(duet), "behind it stands \"Rate 935, overflows 0\"", "d.csv:2");
    EXPECT_EQ(reported_table(duet, {.rate = 935.0})->layout().rate, 935.0);
    expect_error(refusal_of_table("freq,psd_x\n0.0,1.5\n1.6,2.5\n3.2,0.5\n"), "the table is a spectrum", "d.csv:2");
}

TEST(Tables, SayWhatWasUnderstoodOfThem) {
    const auto file = reported_table("n,time [ms],acc [g],state\n" + reported_rows(100, [](int k) {
                                         return fmt::format("{},{:.2f},{:.6f},run", k, 0.25 * k, tone_at(k));
                                     }));
    EXPECT_EQ(file->facts().time, "column 2, \"time\" in ms");
    ASSERT_EQ(file->facts().left_out.size(), 2U);
    EXPECT_EQ(file->facts().left_out[0],
              "column 1, \"n\": grows by the same step in every row, as a counter or a time does");
    EXPECT_EQ(file->facts().left_out[1], "column 4, \"state\": holds words");
    EXPECT_EQ(file->facts().units_in_file, Names{"g"});
}

TEST(Temperatures, AreNoTimes) {
    const auto rows = [](const char* format) {
        return reported_rows(
            100, [format](int k) { return fmt::format(fmt::runtime(format), 293.0 + 0.01 * k, 0.25 * k, tone_at(k)); });
    };
    for (const char* unit : {"K", "degC", "°C", "C"}) {
        const auto file = reported_table(fmt::format("T [{}],Zeit [ms],F [N]\n", unit) + rows("{:.2f},{:.2f},{:.4f}"));
        EXPECT_EQ(file->layout().rate, 4000.0) << unit;
        EXPECT_EQ(file->layout().channels.size(), 2U) << unit;
    }
}

TEST(Overloads, AndInfinitiesAreNoData) {
    for (const char* mark : {"9.9E+37", "-9.9E+37", "9.91E+37", "∞", "-∞", "Inf", "NaN", "-9999"}) {
        const auto file = reported_table("time [s],a [g],b [g]\n" + reported_rows(100, [&](int k) {
                                             const std::string a = k == 77 ? mark : fmt::format("{:.4f}", tone_at(k));
                                             return fmt::format("{:.4f},{},{:.4f}", 0.001 * k, a, tone_at(k + 3));
                                         }));
        EXPECT_EQ(shown_channels(*file), Names{"b m/s^2"}) << mark;
        EXPECT_EQ(file->facts().left_out.size(), 1U) << mark;
    }
}

// what other programs save: each is told what it is, and what to do
TEST(Foreign, FilesAreCalledByTheirNames) {
    for (const auto& [mark, word] :
         {std::pair("PK\x03\x04", "spreadsheets"), std::pair("\xD0\xCF\x11\xE0", "spreadsheet"),
          std::pair("\x1F\x8B\x08", "gunzip"), std::pair("\x93NUMPY\x01", "numpy.savetxt"),
          std::pair("UnFinMF ", "Finalize"), std::pair("DIAEXTENDED {@:ENGLISH\n200,acc\n", "DIAdem")})
        expect_error(refusal_of_table(std::string(mark) + std::string(8, '\0')), word, "d.csv");
    expect_error(refusal_of_table(std::string("\x01\x02\x00\x10", 4)), "sox -t raw", "d.csv");
}

std::string uff58_text(const std::string& function, const std::string& ordinate, const std::string& step) {
    return "    -1\n    58\nacc\nNONE\nNONE\nNONE\nNONE\n    " + function +
           "         0    0         0       NONE         1   3       NONE         0   0\n         " + ordinate +
           "         4         1  0.00000E+00  " + step +
           "  0.00000E+00\n"
           "        17    0    0    0 Time                 s                   \n"
           "        12    0    0    0 Acceleration         m/s2                \n"
           "         0    0    0    0 NONE                 NONE                \n"
           "         0    0    0    0 NONE                 NONE                \n"
           "  0.00000E+00  5.00000E-01  0.00000E+00 -5.00000E-01\n    -1\n";
}

TEST(Uff58, HasAMarkOfUtf8BeforeItAtTimes) {
    EXPECT_EQ(shown_channels(*reported_table("\xEF\xBB\xBF" + uff58_text("1", "2", "2.50000E-04"))),
              Names{"acc m/s^2"});
}

TEST(Uff58, OfOtherKindsIsRefusedWithAWayOut) {
    expect_error(refusal_of_table(uff58_text("1", "5", "2.50000E-04")), "Export the time history", "d.csv:9");
    expect_error(refusal_of_table(uff58_text("4", "2", "2.50000E-04")), "Export the time histories", "d.csv");
    expect_error(refusal_of_table(uff58_text("1", "2", "0.00000E+00")), "Write the step into columns 44 to 56",
                 "d.csv:9");
}

// a mark in the first frame tells the number of frames; encoders that write into a pipe leave 0
TEST(Mp3, OfUnevenBitRateIsReadToItsEndThoughNothingTellsIt) {
    const std::string whole = storage::read_file(fixture("lame_vbr.mp3"));
    std::string zero = whole;
    const std::size_t mark = zero.find("Xing");
    ASSERT_NE(mark, std::string::npos);
    zero.replace(mark + 8, 4, 4, '\0');
    const std::vector<signal::Signal> right = all_of(fixture("lame_vbr.mp3"));
    EXPECT_EQ(all_of(input_of(zero))[0].samples, right[0].samples);
    // without the first frame nothing is told of the encoder's delay: at most two frames of 1152 more
    const std::size_t sound = 20 + 192;
    const std::vector<signal::Signal> untold = all_of(input_of(whole.substr(sound)));
    EXPECT_GE(untold[0].samples.size(), right[0].samples.size());
    EXPECT_LE(untold[0].samples.size(), right[0].samples.size() + 2304U);
}

// a tag that was copied from a shorter sound
TEST(Mp3, IsReadToItsEndThoughItsTagTellsFewerFrames) {
    std::string few = storage::read_file(fixture("lame_vbr.mp3"));
    few.replace(few.find("Xing") + 8, 4, std::string("\0\0\0\2", 4));
    EXPECT_EQ(all_of(input_of(few))[0].samples, all_of(fixture("lame_vbr.mp3"))[0].samples);
}

std::string chunk_of(const std::string& name, const std::string& content) {
    const auto size = static_cast<char>(content.size());
    return name + std::string{size, '\0', '\0', '\0'} + content;
}

TEST(Wav, OfASizeOf0HasNoSamplesBeforeAKnownChunk) {
    const std::string format = chunk_of("fmt ", std::string("\1\0\1\0\xA0\x0F\0\0\x40\x1F\0\0\2\0\x10\0", 16));
    const std::string head = "RIFF" + std::string(4, '\0') + "WAVE" + format + "data" + std::string(4, '\0');
    const auto refused = [&](const std::string& behind) {
        return error_of([&] { all_of(input_of(head + behind, "d.wav")); });
    };
    expect_error(refused(chunk_of("LIST", "INFOISFT" + std::string("\4\0\0\0rec1", 8))), "its data chunk is empty",
                 "d.wav");
    expect_error(refused(""), "the WAV file holds no samples", "d.wav");
    EXPECT_EQ(all_of(input_of(head + std::string("LIST\xFF\xFF\xFF\x7F", 8)))[0].samples.size(), 4U)
        << "samples that look like a mark";
}

bool lacks_libmatio() {
    try {
        open_signal(fixture("plain.mat"));
    } catch (const Error& error) {
        return error.problem().why.find("libmatio") != std::string::npos;
    }
    return false;
}

TEST(Structures, OfMatlabAndSimulinkAreRead) {
    STRIDOR_NEEDS(!lacks_libmatio(), "libmatio", "libmatio-dev");
    const auto structure = open_signal(fixture("structure.mat"));
    EXPECT_EQ(structure->layout().rate, 1000.0) << "by data.fs";
    EXPECT_EQ(shown_channels(*structure), Names{"data.force FS"});
    EXPECT_EQ(structure->facts().left_out, Names{"data.note (text)"});
    const auto simulink = open_signal(fixture("simulink.mat"));
    EXPECT_EQ(simulink->layout().rate, 1000.0) << "by rig.time";
    EXPECT_EQ(simulink->facts().time, "rig.time");
    EXPECT_EQ(shown_channels(*simulink), (Names{"rig.signals(1).values FS", "rig.signals(2).values FS"}));
    const std::vector<signal::Signal> found = signal::read_all(*simulink);
    for (std::size_t k = 0; k < 12; ++k)
        EXPECT_EQ(found[1].samples[k], 2.0 * static_cast<double>(k) / 7.0);
}

TEST(SampledMotions, KnowTheUnitsOfFrontEnds) {
    const SampledMotion motion = read_sampled_csv("time (msec),velocity (mm/sec)\n0,1\n10,2\n", "v.csv");
    EXPECT_NEAR(motion.times[1], 0.01, 1e-15);
    EXPECT_NEAR(motion.velocities[1], 2e-3, 1e-15);
}

}  // namespace
}  // namespace stridor::recordings
