// Tables of other programs, kind by kind: what they mean must not be read wrongly without a word.

#include "signal_support.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "support/expected_error.hpp"

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

using ChannelNames = std::vector<std::string>;

double sample_at(int k) {
    return 0.5 * std::sin(2.0 * std::numbers::pi * 0.05 * k);
}

std::string table_rows(int count, const std::function<std::string(int)>& row) {
    std::string text;
    for (int k = 0; k < count; ++k)
        text += row(k) + "\n";
    return text;
}

// rows of a time at 4 kHz and a sample
std::string usual_rows(const char* delimiter = ",") {
    return table_rows(100, [&](int k) { return fmt::format("{:.6f}{}{:.5f}", 0.00025 * k, delimiter, sample_at(k)); });
}

std::unique_ptr<SignalFile> table_of(const std::string& text, const OpenOptions& options = {}) {
    return open_signal(input_of(text, "d.csv"), options);
}

ChannelNames channels_of(const SignalFile& file) {
    ChannelNames names;
    for (const signal::Channel& channel : file.layout().channels)
        names.push_back(channel.name + " " + channel.unit);
    return names;
}

bool says(const SignalFile& file, std::string_view words) {
    const std::vector<std::string>& notes = file.facts().notes;
    return std::any_of(notes.begin(), notes.end(),
                       [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

std::optional<Error> refusal_in(const std::string& text, const OpenOptions& options = {}) {
    return error_of([&] { all_of(input_of(text, "d.csv"), options); });
}

OpenOptions at_rate(double rate) {
    OpenOptions options;
    options.rate = rate;
    return options;
}

TEST(TimesWithoutUnit, AreTakenForSecondsWithANoteOrNotAtAll) {
    EXPECT_TRUE(says(*table_of("time,a [g]\n" + usual_rows()), "the times have no unit and were taken for seconds"));
    EXPECT_TRUE(says(*table_of(usual_rows()), "taken for seconds"));
    EXPECT_FALSE(says(*table_of("time [s],a [g]\n" + usual_rows()), "seconds"));
    EXPECT_FALSE(says(*table_of("Sampling rate: 4 kHz\ntime,a [g]\n" + usual_rows()), "seconds"));
    const std::string whole =
        "time,a [g]\n" + table_rows(100, [](int k) { return fmt::format("{},{:.5f}", 5 * k, sample_at(k)); });
    const auto error = refusal_in(whole);
    expect_error(error, "the times have no unit (in seconds the rate would be 0.2 Hz)", "d.csv:2");
    EXPECT_NE(error->problem().suggestion.find("--rate 200 for milliseconds, --rate 0.2"), std::string::npos);
    EXPECT_EQ(table_of(whole, at_rate(200.0))->layout().rate, 200.0);
    EXPECT_EQ(table_of("time [ms]" + whole.substr(4))->layout().rate, 200.0);
}

TEST(TimesOfOneChannel, AreNotThoseOfTheNext) {
    const auto two = [](const char* head, double step) {
        return head + table_rows(100, [&](int k) {
                   return fmt::format("{:.6f},{:.5f},{:.6f},{:.5f}", 0.00025 * k, sample_at(k), step * k, sample_at(k));
               });
    };
    const char* head = "t1 [s],acc [g],t2 [s],force [N]\n";
    EXPECT_EQ(channels_of(*table_of(two(head, 0.00025))), (ChannelNames{"acc m/s^2", "force N"}));
    EXPECT_EQ(channels_of(*table_of(two(head, 0.001))), ChannelNames{"acc m/s^2"});
    EXPECT_TRUE(says(*table_of(two(head, 0.001)), "\"force\" has times of its own"));
    // the same times in another unit, told or not
    EXPECT_EQ(table_of(two("t1 [s],acc [g],t2 [ms],force [N]\n", 0.25))->layout().channels.size(), 2U);
    EXPECT_EQ(table_of(two("Time [s],acc [g],timestamp,force [N]\n", 250.0))->layout().channels.size(), 2U);
}

const std::string lvm_head = "LabVIEW Measurement\t\nMulti_Headings\tYes\n***End_of_Header***\t\n";

std::string lvm_part(const char* steps = "0.000250\t0.000250", const char* names = "acc\tforce") {
    return fmt::format(
        "Channels\t2\t\t\nY_Unit_Label\tg\tN\t\nDelta_X\t{}\t\n***End_of_Header***\t\t\t\n"
        "X_Value\t{}\tComment\n",
        steps, names);
}

std::string lvm_rows(int count, bool has_times, int remark = -1) {
    return table_rows(count, [&](int k) {
        return (has_times ? fmt::format("{:.6f}", 0.00025 * k) : "") + fmt::format("\t{0:.5f}\t{0:.5f}", sample_at(k)) +
               (k == remark ? "\tstarted" : "");
    });
}

TEST(LabView, HasRemarksBehindItsRows) {
    for (const int remark : {0, 5, 350, 399}) {
        const auto file = table_of(lvm_head + lvm_part() + lvm_rows(400, true, remark));
        EXPECT_EQ(channels_of(*file), (ChannelNames{"acc m/s^2", "force N"})) << remark;
        EXPECT_EQ(signal::read_all(*file)[0].samples.size(), 400U) << remark;
        EXPECT_TRUE(says(*file, "the remarks behind the columns, in 1 row, were left out")) << remark;
    }
}

TEST(LabView, HasAStepForEachChannel) {
    const auto file = table_of(lvm_head + lvm_part("0.000250\t0.000500") + lvm_rows(50, false));
    EXPECT_EQ(channels_of(*file), ChannelNames{"acc m/s^2"});
    EXPECT_EQ(file->layout().rate, 4000.0);
}

TEST(LabView, WritesAHeadingBeforeEachPart) {
    for (const int count : {50, 400}) {
        const std::string part = lvm_part() + lvm_rows(count, false);
        const std::string place = fmt::format("d.csv:{}:1", 9 + count);
        const auto file = table_of(lvm_head + part + part + "\n" + part);
        EXPECT_EQ(signal::read_all(*file)[1].samples.size(), 3U * static_cast<std::size_t>(count));
        EXPECT_TRUE(says(*file, "3 parts with a heading each"));
        expect_error(refusal_in(lvm_head + part + lvm_part("0.001\t0.001") + lvm_rows(9, false)),
                     "here begin other channels", place);
        expect_error(refusal_in(lvm_head + part + lvm_part("0.000250\t0.000250", "acc\tway") + lvm_rows(9, false)),
                     "here begin other channels", place);
    }
}

TEST(Names, AreFoundAboveEmptyRowsAndBelowATitle) {
    EXPECT_EQ(channels_of(*table_of("time [s],acc [g]\n,\n,\n" + usual_rows())), ChannelNames{"acc m/s^2"});
    const std::string rows = table_rows(50, [](int k) { return fmt::format("{0:.5f};{0:.4f}", sample_at(k)); });
    for (const char* title : {"Brake test 7;run 3\n", "Sampling rate;51,2 kHz\n", "Sampling rate: 51200 Hz\n"})
        EXPECT_EQ(channels_of(*table_of(title + ("acc [m/s^2];F [N]\n" + rows), at_rate(51200.0))),
                  (ChannelNames{"acc m/s^2", "F N"}))
            << title;
    EXPECT_EQ(table_of("Sampling rate;51,2 kHz\nacc [m/s^2];F [N]\n" + rows)->layout().rate, 51200.0);
    EXPECT_EQ(table_of("Sample Interval (ms),0.25\nacc [g],F [N]\n" +
                       table_rows(50, [](int k) { return fmt::format("{0:.5f},{0:.4f}", sample_at(k)); }))
                  ->layout()
                  .rate,
              4000.0);
}

TEST(Names, PartedByBlanksMayHaveBlanks) {
    for (const char* head : {"time   force\n[s]    [N]\n", "Time [s]   force [N]\n", "Time [s] force [N]\n"})
        EXPECT_EQ(channels_of(*table_of(head + usual_rows("   "))), ChannelNames{"force N"}) << head;
    const std::string rows =
        table_rows(50, [](int k) { return fmt::format("{0:9.3f} {1:9.4f}  {1:9.5f}", 0.001 * k, sample_at(k)); });
    EXPECT_EQ(channels_of(*table_of("Time [s]   Normal Force [N]   Friction Force [N]\n" + rows)),
              (ChannelNames{"Normal Force N", "Friction Force N"}));
}

TEST(Names, HoldTheirUnitsInManyWays) {
    for (const char* head :
         {"Zeit in ms;Kraft in kN\n", "t/ms;Kraft/kN\n", "Time, ms;Kraft, kN\n", "t / ms;Kraft/(kN)\n"}) {
        const auto file =
            table_of(head + table_rows(50, [](int k) { return fmt::format("{};{:.4f}", k, sample_at(k)); }));
        EXPECT_EQ(file->layout().rate, 1000.0) << head;
        EXPECT_EQ(channels_of(*file), ChannelNames{"Kraft N"}) << head;
    }
    // units alone are no names over a unit
    EXPECT_EQ(table_of("time,v,n\ns,mm/s,rev/min\n" +
                       table_rows(50,
                                  [](int k) {
                                      return fmt::format("{:.3f},{:.4f},{:.4f}", 0.001 * k, sample_at(k), sample_at(k));
                                  }))
                  ->facts()
                  .units_in_file,
              (ChannelNames{"mm/s", "rev/min"}));
}

TEST(Thousands, AreNoDecimals) {
    const auto last = [](const std::string& head, const std::string& other, const std::string& numeral) {
        const auto file = table_of(head + other + "\n" + numeral + "\n", at_rate(9.0));
        return std::pair(signal::read_all(*file).back().samples.back(), says(*file, "a mark between thousands"));
    };
    const std::string names = "Kraft [N];Weg [mm]\n";
    EXPECT_EQ(last(names, "5;0,25", "2;1.500").first, 1500.0 * 1e-3);
    EXPECT_TRUE(last(names, "5;0,25", "2;1.500").second);
    EXPECT_EQ(last(names, "5;0.25", "2;1.500").first, 1.5e-3);
    EXPECT_EQ(last(names, "5;0.25", "2;1,500").first, 1500.0 * 1e-3);
    EXPECT_EQ(last("F [N],x [m]\n", "5,0.25", "2,\"1,500\"").first, 1500.0);
    EXPECT_EQ(last(names, "5;0.25", "2;1'500.25").first, 1500.25e-3);
    EXPECT_EQ(last(names, "5;0,25",
                   "2;1\xC2\xA0"
                   "500,25")
                  .first,
              1500.25e-3);
    EXPECT_EQ(last(names, "5;0,25", "2;1 500,25").first, 1500.25e-3);
    expect_error(
        refusal_in("\"time [s]\",\"F [N]\"\n" +
                   table_rows(50, [](int k) { return fmt::format("\"10,{:03}\",\"25,{:03}\"", k, (7 * k) % 50); })),
        "\"10,000\" may be a decimal number, or one of thousands", "d.csv:2:1");
}

TEST(Rates, AboveATableAreHeldAgainstItsTimes) {
    for (const char* rate : {"# rate: 8000 Hz\n", "SampleRate=8000\n", "Fs: 8 kHz\n", "# fs = 8000\n",
                             "# Sampling Rate [kHz]: 8\n", "dt = 0.125 ms\n"})
        for (const char* names : {"time [s];a [g]\n", "time;a [g]\n", ""}) {
            const std::string text = rate + std::string(names) + usual_rows(";");
            expect_error(refusal_in(text), "the table contradicts itself", *names == '\0' ? "d.csv:2" : "d.csv:3");
            EXPECT_EQ(table_of(text, at_rate(8000.0))->layout().rate, 8000.0) << text.substr(0, 60);
        }
    for (const char* rate : {"Sample_Rate;8000\n", "Abtastfrequenz [Hz];8000\n"})
        expect_error(refusal_in(rate + ("time [s];a [g]\n" + usual_rows(";"))), "contradicts itself", "d.csv:3");
    EXPECT_EQ(table_of("Fs: 4 kHz\n" + usual_rows(";"))->layout().rate, 4000.0);
}

TEST(MarksForNoValue, AreNoSamples) {
    const auto marked = [](const char* first, const char* second, double level) {
        return table_of("time [s],a [g],b [N]\n" + table_rows(400, [&](int k) {
                            const std::string value = fmt::format("{:.4f}", level + sample_at(k));
                            return fmt::format("{:.4f},{:.4f},{}", 0.001 * k, sample_at(k),
                                               k == 77   ? first
                                               : k == 90 ? second
                                                         : value);
                        }));
    };
    for (const auto& [first, second, level] :
         {std::tuple("-999.25", "0", 0.0), std::tuple("32767", "32767", 3.0), std::tuple("1E+30", "0", 0.0),
          std::tuple("1.0E+20", "0", 0.0), std::tuple("-9999", "-999", 0.0), std::tuple("-9999", "-9999", 300.0),
          std::tuple("9999", "9999", 2500.0)})
        EXPECT_EQ(channels_of(*marked(first, second, level)), ChannelNames{"a m/s^2"}) << first;
    EXPECT_TRUE(says(*marked("-9999", "-999", 0.0), "holds -9999 and -999, marks for no value, in 2 of 400 rows"));
    // numbers that others come near
    for (const auto& [first, second, level] : {std::tuple("999", "999", 500.0), std::tuple("9999", "5", 800.0)})
        EXPECT_EQ(marked(first, second, level)->layout().channels.size(), 2U) << first;
}

TEST(Counter, NeedNotGrowToItsEnd) {
    const auto counted = [](const char* name, const std::function<int(int)>& count) {
        return table_of(fmt::format("{},time [s],acc\n", name) + table_rows(300, [&](int k) {
                            return fmt::format("{},{:.5f},{:.4f}", count(k), 0.00025 * k, sample_at(k));
                        }));
    };
    EXPECT_EQ(channels_of(*counted("Packet", [](int k) { return k % 64; })), ChannelNames{"acc FS"});
    EXPECT_EQ(channels_of(*counted("Index", [](int k) { return k + (k > 99 ? 5 : 0); })), ChannelNames{"acc FS"});
    EXPECT_EQ(channels_of(*counted("Left", [](int k) { return 300 - k; })), ChannelNames{"acc FS"});
    EXPECT_EQ(channels_of(*counted("Block", [](int k) { return k / 10; })), ChannelNames{"acc FS"});
    EXPECT_EQ(channels_of(*counted("Sample [-]", [](int k) { return k; })), ChannelNames{"acc FS"});
    EXPECT_EQ(channels_of(*counted("Count [1]", [](int k) { return k; })), ChannelNames{"acc FS"});
    EXPECT_EQ(counted("Way [mm]", [](int k) { return k; })->layout().channels.size(), 2U) << "it has a unit";
    EXPECT_EQ(counted("State", [](int k) { return k / 5 % 2; })->layout().channels.size(), 2U) << "it does not count";
}

TEST(Counter, IsNoChannelForWhoAsksForIt) {
    OpenOptions options;
    options.channel_name = "n";
    expect_error(
        refusal_in(
            "n,time [s],a\n" +
                table_rows(50, [](int k) { return fmt::format("{},{:.4f},{:.4f}", k, 0.001 * k, sample_at(k)); }),
            options),
        "the column \"n\" is no channel (it grows by the same step", "d.csv:1");
}

TEST(Temperature, CalledTIsNotTakenForATimeBeforeT) {
    const std::string rising =
        "T,F [N],t\n" + table_rows(50, [](int k) {
            return fmt::format("{:.3f},{:.4f},{:.4f}", 23.0 + 0.001 * k, sample_at(k), 0.002 * k);
        });
    EXPECT_EQ(table_of(rising)->layout().rate, 500.0);
    const std::string noisy = "# rate: 4000 Hz\nT,acc [g]\n" + table_rows(50, [](int k) {
                                  return fmt::format("{:.3f},{:.4f}", 23.0 + sample_at(k), sample_at(k));
                              });
    EXPECT_EQ(channels_of(*table_of(noisy)), ChannelNames{"acc m/s^2"});
}

TEST(Dates, AreReadAsTheyAreWritten) {
    for (const char* form :
         {"26.11.2026 10:00:{:02}.{:03}", "11/26/2026 10:00:{:02}.{:03} AM", "2026-11-26T10:00:{:02}.{:03}+01:00",
          "10:00:{:02}:{:03}", "59:{:02}.{:03}", "26/11/2026 22:00:{:02},{:03}"}) {
        const auto file = table_of("time;a [g]\n" + table_rows(1500, [&](int k) {
                                       return fmt::format(fmt::runtime(form), k / 1000, k % 1000) +
                                              fmt::format(";{:.4f}", sample_at(k));
                                   }));
        EXPECT_EQ(file->layout().rate, 1000.0) << form;
        EXPECT_EQ(signal::read_all(*file)[0].samples.size(), 1500U) << form;
    }
    const auto error = refusal_in("time;a [g]\n26-Nov-2026 10:00;1\n26-Nov-2026 10:01;2\n26-Nov-2026 10:02;1\n");
    expect_error(error, "the times of \"time\", as \"26-Nov-2026 10:00\", are not read", "d.csv:2");
    EXPECT_NE(error->problem().suggestion.find("--rate"), std::string::npos);
}

TEST(DamagedTimes, GiveWayToARate) {
    std::string text = "time [s],a [g]\n" + usual_rows();
    text.replace(text.find("0.002500"), 8, "NaN");
    expect_error(refusal_in(text), "time = \"NaN\" is no finite sample", "d.csv:12:1");
    EXPECT_EQ(signal::read_all(*table_of(text, at_rate(4000.0)))[0].samples.size(), 100U);
}

TEST(Summary, BehindATableIsNoPartOfIt) {
    const auto file = table_of("time [s],a [g]\n" + usual_rows() + "Max,0.5\nMin,-0.5\n");
    EXPECT_EQ(signal::read_all(*file)[0].samples.size(), 100U);
    EXPECT_TRUE(says(*file, "the text behind the table, from line 102 (\"Max,0.5\") on, was left out"));
}

TEST(Utf16, NeedsNoMark) {
    for (const bool is_big : {false, true}) {
        std::string wide;
        for (const char c : "time [s],a [g]\n" + usual_rows())
            wide += is_big ? std::string{'\0', c} : std::string{c, '\0'};
        EXPECT_EQ(channels_of(*table_of(wide)), ChannelNames{"a m/s^2"});
    }
}

TEST(Numerals, OfFortranAreRead) {
    const auto file = table_of("time [s],F [N]\n0.0D+00,1.5D-01\n1.0D-03,-2.5D+00\n2.0D-03,3.5D+00\n");
    EXPECT_EQ(signal::read_all(*file)[0].samples, (std::vector<double>{0.15, -2.5, 3.5}));
}

TEST(Facts, AboveRowsWithoutNamesAreNoNames) {
    const auto file = table_of("Operator: Smith\nRig: 7\n" + usual_rows());
    EXPECT_EQ(file->layout().rate, 4000.0);
    EXPECT_EQ(file->facts().metadata.size(), 2U);
}

TEST(Rigol, TellsItsStepBesideTheNames) {
    const auto file = table_of("CH1V,CH2V,t0 =-5.0e-01, tInc = 2.5e-04,\n" +
                               table_rows(50, [](int k) { return fmt::format("{0:.4f},{0:.3f},,", sample_at(k)); }));
    EXPECT_EQ(file->layout().rate, 4000.0);
    EXPECT_EQ(file->layout().channels.size(), 2U);
}

TEST(Delimiters, ThatAreNoneAreCalledByTheirNames) {
    expect_error(refusal_in("time [s]|force [N]\n0.000|0.1\n0.001|0.2\n0.002|0.1\n"), "\"|\" parts no columns",
                 "d.csv:3:1");
    expect_error(refusal_in("time force v\n0.000 -3.10-12.34\n0.001 -3.11-12.34\n"), "its numbers touch", "d.csv:3:1");
}

}  // namespace
}  // namespace stridor::recordings
