#include "stridor/recordings/table/signal_csv.hpp"

#include "signal_support.hpp"
#include "stridor/base/text.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/simulation/simulation_tables.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "support/counter_random.hpp"
#include "support/expected_error.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>

namespace stridor::recordings {

using support::error_of;
using support::expect_error;
using support::ScratchFolder;
namespace {

using signal::Signal;

std::optional<Error> csv_refusal(const std::string& text) {
    const auto error = error_of([&] { all_of(input_of(text, "d.csv")); });
    EXPECT_TRUE(!error || error->kind() == ErrorKind::input);
    return error;
}

// where it is; 0 where nothing is wrong
int line_of(const std::optional<Error>& error) {
    return error && error->place() ? error->place()->line : 0;
}

void expect_force(const std::string& text, double rate = 2.0) {
    const std::vector<Signal> found = all_of(input_of(text));
    ASSERT_EQ(found.size(), 1U) << text;
    EXPECT_EQ(found[0].rate, rate) << text;
    EXPECT_EQ(found[0].samples, (std::vector<double>{0.5, -1.0, 2.0})) << text;
}

/// One frame at 100 Hz with given channels.
class OneFrame final : public signal::Source {
public:
    explicit OneFrame(std::vector<signal::Channel> channels) { layout_ = {100.0, std::move(channels), {}}; }
    const signal::ChannelLayout& layout() const override { return layout_; }
    std::size_t read(std::span<double> frames) override {
        if (std::exchange(is_read_, true)) return 0;
        std::fill_n(frames.begin(), layout_.channels.size(), 1.0);
        return 1;
    }

private:
    signal::ChannelLayout layout_;
    bool is_read_ = false;
};

TEST(SignalCsv, SniffsDelimiterDecimalMarkUnitsAndMark) {
    expect_force("time [s],force [N]\n0,0.5\n0.5,-1\n1,2\n");
    expect_force("time;force\ns;N\n0;0,5\n0,5;-1,0\n1;2\n");
    expect_force("\xEF\xBB\xBFt\t\"force (mN)\"\r\n0\t500\r\n0,5\t-1000\r\n1\t+2e3\r\n");
    expect_force("time,force\nms,mN\n0,500\n500,-1000\n1000,2000");
    expect_force("0,0.5\n0.5,-1\n1,2\n");
    expect_force("# rate: 2 Hz\nforce\nN\n0,5\n-1\n2\n");
    expect_force("# lab 7\n# Rate: 2 kHz\n\n0.5\n-1\n\n2\n# end\n", 2000.0);
    expect_force("force,time,state\nN,s,-\n0.5,0,slip\n-1,0.5,stick\n2,1,slip\n");
}

TEST(SignalCsv, KeepsMetadataNamesAndNotes) {
    const auto file = open_signal(input_of("# preload: 20 N\ntime [s],Kraft [EU],state\n0,1,slip\n1,2,slip\n"));
    EXPECT_EQ(file->facts().metadata, (std::vector<std::pair<std::string, std::string>>{{"preload", "20 N"}}));
    EXPECT_EQ(file->layout().channels[0].name, "Kraft");
    EXPECT_EQ(file->layout().channels[0].unit, "EU");
    ASSERT_EQ(file->facts().notes.size(), 2U);
    EXPECT_NE(file->facts().notes[0].find("\"state\" holds words and was left out"), std::string::npos);
    EXPECT_NE(file->facts().notes[1].find("\"EU\""), std::string::npos);
}

TEST(SignalCsv, FindsTheRateBehindRoundedTimes) {
    for (const double rate : {8000.0, 44100.0, 48000.0, 51200.0})
        for (const char* format : {"%.6f,1\n", "%.9f,1\n", "%.17g,1\n", "%.7g,1\n"}) {
            std::string text = "time,v\n";
            for (int k = 0; k < 5000; ++k) {
                std::array<char, 64> row{};
                std::snprintf(row.data(), row.size(), format, k / rate);
                text += row.data();
            }
            const std::vector<Signal> found = all_of(input_of(text));
            EXPECT_EQ(found[0].rate, rate) << format;
            EXPECT_EQ(found[0].samples.size(), 5000U);
        }
}

TEST(SignalCsv, SaysWhatRateItTook) {
    const auto file =
        open_signal(input_of("time [s],v\n0,1\n0.000021,2\n0.000042,3\n0.000063,4\n0.000083,4\n0.000104,4\n"));
    EXPECT_EQ(file->layout().rate, 48000.0);
    ASSERT_EQ(file->facts().notes.size(), 1U);
    EXPECT_NE(file->facts().notes[0].find("was taken for 48000 Hz"), std::string::npos);
}

TEST(SignalCsv, PointsAtAnUnevenStep) {
    std::string text = "time,v\n";
    for (int k = 0; k < 3000; ++k)
        if (k != 2500) text += base::shortest(k * 0.001) + ",1\n";
    expect_error(csv_refusal(text), "the times are not evenly spaced", "d.csv:2502:1");
    expect_error(csv_refusal("t,v\n0,1\n1,1\n2.5,1\n"), "not evenly spaced", "d.csv:3:1");
    expect_error(csv_refusal("t,v\n0,1\n1,1\n1,1\n"), "the times do not increase", "d.csv:4:1");
}

TEST(SignalCsv, PointsAtTheFieldThatIsNoNumber) {
    expect_error(csv_refusal("# rate: 9\nv\n1\n2\nx\n"), "v = \"x\" is not a number", "d.csv:5:1");
    expect_error(csv_refusal("# rate: 9\nb\n1\nnan\n"), "b = \"nan\" is no finite sample", "d.csv:4:1");
    expect_error(csv_refusal("# rate: 9\na,b\n,2\n3,\n"), "(the field is empty)", "d.csv:3:1");
    expect_error(csv_refusal("# rate: 9\na,b\n1,2\n3\n"), "the row has 1 columns", "d.csv:4:1");
    expect_error(csv_refusal("time,b\n1,1e999\n"), "is no finite sample", "d.csv:2:3");
}

TEST(SignalCsv, RefusesWhatHasNoRateOrSamples) {
    expect_error(csv_refusal("a,b\n1,2\n3,4\n"), "does not tell its sampling rate", "d.csv:2");
    expect_error(csv_refusal("t,b\n1,2\n"), "one row does not tell the sampling rate", "d.csv:2");
    expect_error(csv_refusal("time\n1\n2\n"), "no column of samples", "d.csv:2");
    expect_error(csv_refusal("# rate: 0\n1\n"), "is no sampling rate", "d.csv:1:1");
    expect_error(csv_refusal("# rate: 5 N\n1\n"), "is a force (N)", "d.csv:1:1");
    expect_error(csv_refusal("only words\n"), "no row of numbers", "d.csv:1:1");
    expect_error(csv_refusal("# rate: 9\n"), "holds no table", "d.csv");
    expect_error(csv_refusal(std::string("\xFF\xFEt\0,\0", 6)), "no row of numbers", "d.csv:1:1");
    expect_error(csv_refusal(std::string(200000, '1')), "the line has more than 65536 bytes", "d.csv:1");
}

TEST(SignalCsv, GivesBackEveryBitOfWhatItWrote) {
    const ScratchFolder scratch;
    support::CounterRandom random(7);
    Signal a{48000.0 / 7.0, "m/s^2", {}}, b{48000.0 / 7.0, "FS", {}};
    for (int k = 0; k < 30000; ++k) {
        a.samples.push_back(random.between(-1e3, 1e3) * 1e-3);
        b.samples.push_back(random.one_in(2) ? 5e-324 : -random.decades(1e-300, signal::largest_sample));
    }
    EXPECT_EQ(write_signal_csv((scratch / "a.csv").string(), *signal::source_of({a, b})), 30000U);
    const std::vector<Signal> back = all_of((scratch / "a.csv").string());
    ASSERT_EQ(back.size(), 2U);
    EXPECT_EQ(back[0].rate, a.rate);
    EXPECT_EQ(back[0].unit, "m/s^2");
    EXPECT_EQ(back[0].samples, a.samples);
    EXPECT_EQ(back[1].unit, "FS");
    EXPECT_EQ(back[1].samples, b.samples);
}

TEST(SignalCsv, NamesOfChannelsAreNoFormulasAndComeBack) {
    const ScratchFolder scratch;
    const std::vector<std::string> names{"=1+1", "+cmd|' /C calc'!A0", "-2+3", "@SUM A1", "''=1", "'plain'", "door"};
    std::string given = "time";
    std::string row = "s";
    for (const std::string& name : names) {
        given += "," + name;
        row += ",-0.1257";
    }
    storage::write_file((scratch / "given.csv").string(),
                        given + "\n0" + row.substr(1) + "\n0.5" + row.substr(1) + "\n");
    const std::string path = (scratch / "a.csv").string();
    write_signal_csv(path, *open_signal((scratch / "given.csv").string()));
    std::ifstream stream(path);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    EXPECT_NE(text.find("\ntime [s],'=1+1 [FS],'+cmd|' /C calc'!A0 [FS],'-2+3 [FS],'@SUM A1 [FS],''=1 [FS],'plain' "
                        "[FS],door [FS]\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("\n0,-0.1257,-0.1257,"), std::string::npos) << "numbers stay numbers";
    const auto file = open_signal(path);
    for (std::size_t k = 0; k < names.size(); ++k)
        EXPECT_EQ(file->layout().channels[k].name, names[k] == "''=1" ? "'=1" : names[k]);
}

TEST(SignalCsv, KeepsNamesAndUnitsOfWhatItWrote) {
    const ScratchFolder scratch;
    const std::string path = (scratch / "a.csv").string();
    OneFrame source({{"acceleration (front) [z]", "m/s^2"}, {"a;b", "1"}, {"c\td, e", "FS"}, {"x#1", "N"}});
    write_signal_csv(path, source);
    const auto file = open_signal(path);
    EXPECT_EQ(file->layout().rate, 100.0);
    ASSERT_EQ(file->layout().channels.size(), source.layout().channels.size());
    for (std::size_t k = 0; k < source.layout().channels.size(); ++k) {
        EXPECT_EQ(file->layout().channels[k].name, source.layout().channels[k].name);
        EXPECT_EQ(file->layout().channels[k].unit, source.layout().channels[k].unit);
    }
}

TEST(SignalCsv, ReadsTheTablesOfBothGenerations) {
    expect_force("# schema: stridor.signal/1\n# version: 0.1.0\n# rate: 2 Hz\ntime,force\ns,N\n0,0.5\n0.5,-1\n1,2\n");
    expect_force("# schema: stridor.signal/1 | version: 0.1.0 | rate: 2 Hz\ntime [s],force [N]\n0,0.5\n0.5,-1\n1,2\n");
    const auto facts = open_signal(input_of("# schema: stridor.trace/1 | rate: 2 Hz | a: b | c: d\nv\n1\n"))->facts();
    EXPECT_EQ(facts.metadata, (std::vector<std::pair<std::string, std::string>>{
                                  {"schema", "stridor.trace/1"}, {"a", "b"}, {"c", "d"}}));
}

TEST(SignalCsv, SaysThatAChartIsNoSignal) {
    for (const char* what : {"chart", "boundaries", "history", "library", "evaluate"}) {
        const std::string schema = "# schema: stridor." + std::string(what) + "/1";
        expect_error(csv_refusal(schema + "\n# version: 1\nx,y\nN,1\n1,2\n"), "holds no signal over time", "d.csv:1:1");
        expect_error(csv_refusal(schema + " | version: 1\nx [N],y\n1,2\n"), "holds no signal over time", "d.csv:1:1");
    }
}

TEST(SignalCsv, FindsTheTableBelowProse) {
    const std::string prose = "Measurement report\nDate;2024-05-03;12:00\nOperator: M\xC3\xBCller\n\n";
    expect_force(prose + "time;force\ns;N\n0;0,5\n0,5;-1\n1;2\n");
    expect_force(prose + "time [s];force [N]\n0;0,5\n0,5;-1\n1;2\n");
    expect_force(prose + "time [s],force [N]\n0,0.5\n0.5,-1\n1,2\n");
    expect_force(prose + "Zeit\tforce\ns\tmN\n0\t500\n0,5\t-1000\n1\t2000\n");
    expect_force(prose + "0;0.5\n0.5;-1\n1;2\n");
    // a column alone: what stands above its name is no name whose unit the name would be
    const std::string spoken = "Measurement report\nSampling rate: 2 Hz\n";
    for (const char* name : {"force [N]\n", "force (N)\n", "force\n[N]\n", "force\nN\n", "force\n"})
        expect_force(spoken + name + "0.5\n-1\n2\n");
    expect_force("Test rig 3\ntime,force\n0,0.5\n0.5,-1\n1,2\n");
    expect_force("operator;Smith\ntime;force\n0;0.5\n0.5;-1\n1;2\n");
    // lists of channels, and keys with two numbers, come close to rows
    expect_force("No;Name;Unit\n1;force;N\n2;way;mm\n\ntime;force\ns;N\n0;0.5\n0.5;-1\n1;2\n");
    expect_force(
        "LabVIEW Measurement\t\nSamples\t3\t3\t\nX0\t0.0\t0.0\t\nDelta_X\t0.5\t0.5\t\n***End_of_Header***\t\t\t\n"
        "X_Value\tforce\tComment\n0.0\t0.5\n0.5\t-1.0\n1.0\t2.0\n");
}

TEST(SignalCsv, TakesNoDamagedRowForTheEndOfProse) {
    std::string rows = "time;force\n";
    for (const char* row : {"0;1", "1;2", "2;3"})
        rows += std::string(row) + "\n";
    for (const char* damaged : {";4", "x;4", "3;", "n/a;n/a", "3;4;5"})
        EXPECT_EQ(line_of(csv_refusal(rows + damaged + "\n4;5\n5;6\n")), 5) << damaged;
    EXPECT_TRUE(csv_refusal("time;force\nx;4\n1;5\n2;6\n"));
}

TEST(SignalCsv, TakesRateAndMetadataFromProse) {
    for (const char* rate : {"Sampling rate: 2 Hz", "Sampling frequency [kHz];0,002", "Abtastrate = 2"})
        expect_force("Door seal\n" + std::string(rate) + "\nNormal load [N]: 20\n\nforce\n0,5\n-1\n2\n");
    const auto file = open_signal(input_of("Door seal\nNormal load [N]: 20\nSampling rate: 1 Hz\nt;v\n0;1\n1;2\n"));
    EXPECT_EQ(file->layout().rate, 1.0);
    EXPECT_EQ(file->facts().metadata, (std::vector<std::pair<std::string, std::string>>{{"Normal load", "20 N"}}));
    ASSERT_FALSE(file->facts().notes.empty());
    EXPECT_EQ(file->facts().notes[0], "3 lines of text above the table taken for metadata");
}

TEST(TraceCsv, TellsItsRateWhateverItsLength) {
    const parameters::Case c = parameters::paper_case(parameters::PaperCase::squeal);
    for (const double interval : {20e-6, 1e-3, 1e-3 / 3.0})
        for (const double to : {0.02, 0.02 + 1e-9, 0.021, 0.03}) {
            record::Request request;
            request.trace = {0.02, to, interval};
            const integration::Motion motion = integration::simulate(c, request);
            const std::string text = io::trace_csv(c, motion.record.trace, interval);
            if (motion.record.trace.time.empty()) continue;
            const auto file = open_signal(input_of(text));
            EXPECT_NEAR(file->layout().rate * interval, 1.0, 1e-12) << interval << " s until " << to;
            EXPECT_EQ(signal::read_all(*file)[0].samples.size(), motion.record.trace.time.size());
        }
}

TEST(LineReader, TakesAnyLineEndsAcrossItsBlocks) {
    // lengths that put line ends on, before and behind the ends of blocks
    std::string text;
    std::vector<std::string> wanted;
    support::CounterRandom random(3);
    for (int k = 0; k < 60; ++k) {
        wanted.push_back(std::string(random.one_in(4) ? 65536 - random.below(3) : random.below(40), 'x'));
        text += wanted.back() + (random.one_in(3) ? "\n" : random.one_in(2) ? "\r\n" : "\r");
    }
    wanted.push_back("end");
    text += "end";
    LineReader lines(bytes_of(text), "t");
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        // an empty line after a CR cannot be told from CR LF
        const auto line = lines.next();
        ASSERT_TRUE(line) << k;
        if (line->text.empty() && !wanted[k].empty()) FAIL() << k;
        if (!line->text.empty()) {
            ASSERT_EQ(text.substr(line->offset, line->text.size()), line->text);
        }
        if (line->text != wanted[k]) {
            // the pair was one line end: skip the empty one that it swallowed
            while (k + 1 < wanted.size() && wanted[k].empty() && line->text != wanted[k])
                ++k;
            ASSERT_EQ(line->text, wanted[k]);
        }
    }
    EXPECT_FALSE(lines.next());
}

}  // namespace
}  // namespace stridor::recordings
