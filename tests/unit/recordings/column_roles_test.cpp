#include "signal_support.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "support/expected_error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace stridor::recordings {

using support::error_of;
using support::expect_error;
namespace {

// a tone, so that nothing in it counts evenly
double tone(int k) {
    return 0.5 * std::sin(2.0 * std::numbers::pi * 0.05 * k);
}

std::string rows(int count, const std::function<std::string(int)>& row) {
    std::string text;
    for (int k = 0; k < count; ++k)
        text += row(k) + "\n";
    return text;
}

std::unique_ptr<SignalFile> opened(const std::string& text, const OpenOptions& options = {}) {
    return open_signal(input_of(text, "d.csv"), options);
}

std::vector<std::string> names_of(const SignalFile& file) {
    std::vector<std::string> names;
    for (const signal::Channel& channel : file.layout().channels)
        names.push_back(channel.name);
    return names;
}

bool notes(const SignalFile& file, std::string_view words) {
    const std::vector<std::string>& all = file.facts().notes;
    return std::any_of(all.begin(), all.end(),
                       [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

std::optional<Error> refused(const std::string& text, const OpenOptions& options = {}) {
    return error_of([&] { all_of(input_of(text, "d.csv"), options); });
}

using Names = std::vector<std::string>;

TEST(TimeColumn, IsReadInTheUnitItSays) {
    for (const char* unit : {"msec", "ms", "msecs", "milliseconds", "Milliseconds", "millis"}) {
        const auto file = opened(fmt::format("Time ({}),Force (N)\n", unit) +
                                 rows(50, [](int k) { return fmt::format("{},{:.4f}", k, tone(k)); }));
        EXPECT_EQ(file->layout().rate, 1000.0) << unit;
        EXPECT_EQ(names_of(*file), Names{"Force"}) << unit;
    }
    EXPECT_EQ(open_signal(fixture("11_latin.csv"))->layout().rate, 2000.0) << "the micro sign of Latin-1";
    EXPECT_NEAR(open_signal(fixture("11_msec_three_rows.csv"))->layout().rate, 2e9, 1.0);
    EXPECT_EQ(opened("time_us,v\n" + rows(50, [](int k) { return fmt::format("{},{:.4f}", 50 * k, tone(k)); }))
                  ->layout()
                  .rate,
              20000.0);
}

TEST(TimeColumn, InAnUnknownUnitIsRefusedAndNeverTakenForSeconds) {
    for (const char* unit : {"ticks", "samples", "fortnights", "-"}) {
        const std::string text =
            fmt::format("Time [{}],v\n", unit) + rows(50, [](int k) { return fmt::format("{},{:.4f}", k, tone(k)); });
        expect_error(refused(text), "no unit of time that is known", "d.csv:1");
        OpenOptions options;
        options.rate = 1000.0;
        EXPECT_EQ(opened(text, options)->layout().rate, 1000.0) << "the way out works";
        EXPECT_EQ(names_of(*opened(text, options)), Names{"v"});
    }
}

TEST(TimeColumn, IsNoTemperatureThoughItIsCalledT) {
    const auto file = opened("T [degC],t [ms],p [Pa]\n" + rows(50, [](int k) {
                                 return fmt::format("{:.2f},{},{:.4f}", 20.0 + 0.01 * (k % 3), k, tone(k));
                             }));
    EXPECT_EQ(file->layout().rate, 1000.0);
    EXPECT_EQ(names_of(*file), (Names{"T", "p"}));
}

TEST(TimeColumn, MayCountFrom1970) {
    struct Epoch {
        const char* zeros;
        int step;
    };
    for (const Epoch& epoch : {Epoch{"", 1}, Epoch{"000", 1000}, Epoch{"000000", 1000000}}) {
        const auto file =
            opened("timestamp,v\n" + rows(50, [&](int k) {
                       return fmt::format("{},{:.4f}", 1710151200000LL * (epoch.step) + k * epoch.step, tone(k));
                   }));
        EXPECT_EQ(file->layout().rate, 1000.0) << epoch.zeros;
        EXPECT_TRUE(notes(*file, "since 1970"));
    }
}

TEST(TimeColumn, IsHeldAgainstTheRateThatIsSaidAboveIt) {
    const std::string table = "time,v\n" + rows(50, [](int k) { return fmt::format("{},{:.4f}", k, tone(k)); });
    expect_error(refused("Door seal\nSampling rate: 1000 Hz\n\n" + table), "the table contradicts itself", "d.csv:5");
    expect_error(refused("# rate: 1000\n" + table), "its times tell 1 Hz", "d.csv:3");
    OpenOptions options;
    options.rate = 1000.0;
    const auto file = opened("Sampling rate: 1000 Hz\n\n" + table, options);
    EXPECT_EQ(file->layout().rate, 1000.0);
    EXPECT_TRUE(notes(*file, "the times tell 1 Hz and were left out"));
}

TEST(TimeColumn, OfEachChannelIsNoSignal) {
    const std::string head =
        "LabVIEW Measurement\t\nX_Columns\tMulti\n***End_of_Header***\t\n\t\nChannels\t2\t\t\t\n"
        "Y_Unit_Label\tg\t\tN\t\nDelta_X\t0.00025\t\t0.00025\t\n***End_of_Header***\t\t\t\t\n";
    const auto file = opened(head + "X_Value\tax\tX_Value\tF\tComment\n" + rows(50, [](int k) {
                                 return fmt::format("{0:.6f}\t{1:.4f}\t{0:.6f}\t{1:.4f}", 0.00025 * k, tone(k));
                             }));
    EXPECT_EQ(file->layout().rate, 4000.0);
    EXPECT_EQ(names_of(*file), (Names{"ax", "F"}));
    EXPECT_EQ(file->layout().channels[0].unit, "m/s^2");
    EXPECT_EQ(file->layout().channels[1].unit, "N");
    const auto other =
        opened(head + "X_Value\tax\tX_Value\tF\tComment\n" + rows(50, [](int k) {
                   return fmt::format("{:.6f}\t{:.4f}\t{:.6f}\t{:.4f}", 0.00025 * k, tone(k), 0.001 * k, tone(k));
               }));
    EXPECT_EQ(names_of(*other), Names{"ax"});
    EXPECT_TRUE(notes(*other, "\"F\" has times of its own"));
}

TEST(TimeColumn, MayBeEmptyWhereAStepIsSaid) {
    const auto file = opened(
        "LabVIEW Measurement\t\nDecimal_Separator\t,\nX_Columns\tNo\n***End_of_Header***\t\n\t\nChannels\t2\t\t\n"
        "Y_Unit_Label\tm/s^2\tN\t\nX0\t0E+0\t0E+0\t\nDelta_X\t0,000250\t0,000250\t\n***End_of_Header***\t\t\t\n"
        "X_Value\tacc\tforce\tComment\n" +
        rows(400, [](int k) {
            std::string row = fmt::format("\t{0:.6f}\t{0:.6f}", tone(k));
            std::replace(row.begin(), row.end(), '.', ',');
            return row;
        }));
    EXPECT_EQ(file->layout().rate, 4000.0);
    EXPECT_EQ(names_of(*file), (Names{"acc", "force"}));
    EXPECT_EQ(file->layout().channels[0].unit, "m/s^2");
    EXPECT_EQ(file->layout().channels[1].unit, "N");
    EXPECT_EQ(signal::read_all(*file)[1].samples.size(), 400U);
}

TEST(ColumnWithoutSamples, IsLeftOutWithANote) {
    const auto lvm = open_signal(fixture("05_empty_columns_at_end.lvm"));
    EXPECT_EQ(names_of(*lvm), Names{"acc"});
    EXPECT_EQ(lvm->layout().rate, 4000.0);
    EXPECT_EQ(signal::read_all(*lvm)[0].samples.size(), 400U);
    EXPECT_TRUE(notes(*lvm, "\"Untitled 0\" is empty"));

    const auto gaps = opened("Time [s],a,empty,b\n" + rows(50, [](int k) {
                                 return fmt::format("{0:.3f},{1:.4f},,{1:.4f}", 0.001 * k, tone(k));
                             }));
    EXPECT_EQ(names_of(*gaps), (Names{"a", "b"}));
}

TEST(ColumnWithoutSamples, ThatNobodyAskedForDoesNotBlockTheFile) {
    const auto table = [](const char* name, const std::function<std::string(int)>& field) {
        return fmt::format("Time [s],F [N],{}\n", name) +
               rows(2000, [&](int k) { return fmt::format("{:.3f},{:.4f},{}", 0.001 * k, tone(k), field(k)); });
    };
    const std::string slow = table("T_disc [degC]", [](int k) { return k % 10 == 0 ? "20.0" : ""; });
    const std::string state = table("OVL", [](int k) { return k < 1500 ? "0" : "OVR"; });
    const auto with = [&](const char* field) {
        return table("x [N]", [=](int k) { return k == 7 ? field : fmt::format("{:.4f}", tone(k)); });
    };
    const std::string overload = with("9.9E+37");
    const std::string infinite = with("\xE2\x88\x9E");
    const std::string mark = with("-9999");
    for (const std::string& text : {slow, state, overload, infinite, mark}) {
        const auto file = opened(text);
        EXPECT_EQ(names_of(*file), Names{"F"});
        EXPECT_EQ(file->layout().rate, 1000.0);
        EXPECT_EQ(signal::read_all(*file)[0].samples.size(), 2000U);
    }
    EXPECT_TRUE(notes(*opened(slow), "\"T_disc\" has no number in 1800 of 2000 rows (first in line 3"));
    EXPECT_TRUE(notes(*opened(mark), "\"x\" holds -9999, a mark for no value, in 1 of 2000 rows"));
    OpenOptions asked;
    asked.channel_name = "OVL";
    expect_error(refused(state, asked), "OVL = \"OVR\" is not a number", "d.csv:1502:15");
    asked.channel_name = "x";
    expect_error(refused(overload, asked), "for an overload", "d.csv:9:14");
}

TEST(ColumnWithoutSamples, IsRefusedWhereItIsTheOnlyOne) {
    expect_error(refused("time,v\n0,1\n0.5,\n1,2\n"), "v = \"\" is not a number (the field is empty)", "d.csv:3:5");
    expect_error(refused("time,v\n0,1\n0.5,9.9E+37\n1,2\n"), "instruments write such numbers", "d.csv:3:5");
}

TEST(TextBehindATable, IsLeftOutWithANote) {
    const std::string table =
        "Time [s],F [N]\n" + rows(50, [](int k) { return fmt::format("{:.3f},{:.4f}", 0.001 * k, tone(k)); });
    for (const char* text : {"\nEnd of test,\n", "End of test\n", "\nMaximum,see page 2\nEnd\n"}) {
        const auto file = opened(table + text);
        EXPECT_EQ(signal::read_all(*file)[0].samples.size(), 50U) << text;
        EXPECT_TRUE(notes(*file, "the text behind the table")) << text;
    }
    expect_error(refused(table + "Pause,\n0.050,1\n"), "the table is interrupted by text", "d.csv:52:1");
}

TEST(Counter, IsNoSignal) {
    const auto counted = [](const char* head) {
        return head + rows(50, [](int k) { return fmt::format("{},{:.5f},{:.4f}", k, 0.00025 * k, tone(k)); });
    };
    for (const char* head : {",time,mic\n", "index,time,mic\n", "\"\",\"time [s]\",\"mic\"\n"}) {
        const auto file = opened(counted(head));
        EXPECT_EQ(names_of(*file), Names{"mic"}) << head;
        EXPECT_EQ(file->layout().rate, 4000.0) << head;
        EXPECT_TRUE(notes(*file, "a counter")) << head;
    }
    // without any other time a counter is none either
    expect_error(refused("n,mic\n" + rows(50, [](int k) { return fmt::format("{},{:.4f}", k, tone(k)); })),
                 "does not tell its sampling rate", "d.csv:2");
}

TEST(Counter, BesideEmptyColumnsAndTwoTimesIsATribometersFile) {
    const auto file = opened(
        "MTM311 Test Data File\nStep 1 started at 19/08/2016 09:48:51\n"
        "Step Time (s)\tTraction Coeff (-)\t\t\tStep Time (s)\tBall Load (N)\tPin Load (N)\tWear "
        "(um)\tTraction Force (N)\t\n" +
        rows(50, [](int k) {
            return fmt::format("{0:.3f}\t{1:.4f}\t\t\t{0:.3f}\t10.0\t\t-75\t{1:.4f}\t", 0.001 * k, 2.0 + tone(k));
        }));
    EXPECT_EQ(names_of(*file), (Names{"Traction Coeff", "Ball Load", "Wear", "Traction Force"}));
    EXPECT_EQ(file->layout().rate, 1000.0);
}

TEST(Blanks, PartATable) {
    const auto row = [](int k) { return fmt::format("{:8.3f}    {:8.5f}", 0.001 * k, tone(k)); };
    for (const char* head : {"Time(s)  Force(N)\n", "Time (s)  Force (N)\n", "# made by numpy\n", ""}) {
        const auto file = opened(head + rows(50, row));
        EXPECT_EQ(file->layout().rate, 1000.0) << head;
        EXPECT_EQ(file->layout().channels.size(), 1U) << head;
        EXPECT_EQ(signal::read_all(*file)[0].samples[1], std::stod(fmt::format("{:.5f}", tone(1)))) << head;
    }
    const auto saved = opened(rows(50, [](int k) { return fmt::format("{:.18e} {:.18e}", k * 0.001, tone(k)); }));
    EXPECT_EQ(saved->layout().rate, 1000.0);
    expect_error(refused(rows(50, row) + "0.050 1 2\n" + rows(3, row)), "the row has 3 columns", "d.csv:51:9");
}

TEST(DecimalComma, MayStandInQuotesBetweenCommas) {
    const auto file = opened("time [s],F [N]\n" + rows(50, [](int k) {
                                 std::string row = fmt::format("\"{:.3f}\",\"{:.4f}\"", 0.001 * k, tone(k));
                                 std::replace(row.begin(), row.end(), '.', ';');
                                 std::replace(row.begin(), row.end(), ';', ',');
                                 return row;
                             }));
    EXPECT_EQ(file->layout().rate, 1000.0);
    EXPECT_NEAR(signal::read_all(*file)[0].samples[1], tone(1), 1e-4);
    // thousands are no decimals
    EXPECT_TRUE(refused("time,F\n0,\"1,234\"\n1,\"2,345\"\n2,\"1,111\"\n"));
}

TEST(Oscilloscope, TellsItsStepAboveTheTable) {
    const auto rigol = opened("X,CH1,Start,Increment,\nSequence,Volt,-6.000000e-04,5.000000e-05\n" +
                              rows(50, [](int k) { return fmt::format("{},{:.4e},,", k, tone(k)); }));
    EXPECT_EQ(names_of(*rigol), Names{"CH1"});
    EXPECT_EQ(rigol->layout().rate, 20000.0);
    EXPECT_EQ(rigol->layout().channels[0].unit, "V");
    EXPECT_EQ(signal::read_all(*rigol)[0].samples.size(), 50U);
    const auto tektronix =
        opened("Model,MSO24\nSample Interval,5e-05\nVertical Units,V\n\nTIME,CH1\n" +
               rows(50, [](int k) { return fmt::format("{:.6f},{:.4e}", -0.001 + 5e-5 * k, tone(k)); }));
    EXPECT_EQ(tektronix->layout().rate, 20000.0);
    EXPECT_EQ(names_of(*tektronix), Names{"CH1"});
}

TEST(Oscilloscope, OfTheOldKindHasFactsBesideItsFirstRows) {
    constexpr std::array facts{"Record Length,2.5e+03,", "Sample Interval,5e-05,", "Source,CH1,", "Vertical Units,V,"};
    const auto file = opened(rows(60, [&](int k) {
        const std::string fact = k < 4 ? facts[static_cast<std::size_t>(k)] : ",,";
        return fmt::format("{},{:.6f},{:.4f},", fact, -0.001 + 5e-5 * k, tone(k));
    }));
    EXPECT_EQ(file->layout().rate, 20000.0);
    ASSERT_EQ(file->layout().channels.size(), 1U);
    const std::vector<double> samples = signal::read_all(*file)[0].samples;
    ASSERT_EQ(samples.size(), 60U) << "no sample beside a fact is dropped";
    EXPECT_NEAR(samples[1], tone(1), 1e-4);
}

TEST(TimeColumn, MayBeWrittenAsAClockOrADate) {
    for (const char* form : {"10:00:{:06.3f}", "2024-03-11 10:00:{:06.3f}", "2024-03-11T10:00:{:06.3f}Z"}) {
        const auto file =
            opened("Time,F [N]\n" + rows(50, [&](int k) {
                       return fmt::format(fmt::runtime(form), 3.0 + 0.001 * k) + fmt::format(",{:.4f}", tone(k));
                   }));
        EXPECT_EQ(file->layout().rate, 1000.0) << form;
        EXPECT_EQ(names_of(*file), Names{"F"}) << form;
    }
}

TEST(Utf16, IsReadInBothOrders) {
    const std::string text =
        "Zeit [\xC2\xB5s]\tKraft [N]\n" + rows(50, [](int k) { return fmt::format("{}\t{:.4f}", 100 * k, tone(k)); });
    for (const bool is_big : {false, true}) {
        std::string wide = is_big ? "\xFE\xFF" : "\xFF\xFE";
        for (std::size_t k = 0; k < text.size(); ++k) {
            const bool is_micro = text[k] == '\xC2';
            const char low = is_micro ? text[++k] : text[k];
            wide += is_big ? std::string{'\0', low} : std::string{low, '\0'};
        }
        const auto file = opened(wide);
        EXPECT_EQ(file->layout().rate, 10000.0);
        EXPECT_EQ(names_of(*file), Names{"Kraft"});
        EXPECT_EQ(file->layout().channels[0].unit, "N");
    }
}

}  // namespace
}  // namespace stridor::recordings
