#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

using stridor::support::Finished;
using stridor::support::Launch;
using stridor::support::read_text;
using stridor::support::run;
using stridor::support::ScratchFolder;
using stridor::support::write_text;

namespace {

std::string squeal_with(const std::string& from, const std::string& to) {
    std::string text = run({"init", "squeal"}).out;
    const std::size_t place = text.find("\n" + from);
    EXPECT_NE(place, std::string::npos) << "no line starts with " << from;
    const std::size_t end = text.find('\n', place + 1);
    return text.replace(place, end - place, "\n" + to);
}

// every refusal: the exit code, nothing on stdout, and a message that holds these words
void expect_refused(const Finished& finished, int exit_code, const std::vector<std::string>& words) {
    EXPECT_EQ(finished.signal, 0) << finished.err;
    EXPECT_EQ(finished.exit_code, exit_code) << finished.err;
    EXPECT_EQ(finished.out, "");
    for (const std::string& word : words)
        EXPECT_NE(finished.err.find(word), std::string::npos) << "\"" << word << "\" is not in:\n" << finished.err;
}

Finished simulate(const std::string& text, const std::vector<std::string>& more = {}) {
    const ScratchFolder folder;
    write_text(folder / "case.toml", text);
    std::vector<std::string> arguments{"simulate", "case.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments, folder.path());
}

}  // namespace

TEST(BadInput, AMissingKeyIsNamed) {
    expect_refused(simulate(squeal_with("preload =", "")), 2, {"contact.preload", "case.toml"});
}

TEST(BadInput, AnUnknownKeyIsShownWithItsPlaceAndASuggestion) {
    expect_refused(simulate(squeal_with("preload =", "prelaod = 20")), 2, {"case.toml:", "prelaod", "preload", "^"});
}

TEST(BadInput, ADuplicateKeyIsShownWithItsPlace) {
    expect_refused(simulate(squeal_with("preload =", "preload = 20\npreload = 30")), 2, {"case.toml:", "preload"});
}

TEST(BadInput, ANumberThatIsNotFiniteIsRefused) {
    expect_refused(simulate(squeal_with("preload =", "preload = nan")), 2, {"case.toml:", "preload", "finite"});
    expect_refused(simulate(squeal_with("preload =", "preload = inf")), 2, {"case.toml:", "preload", "finite"});
}

TEST(BadInput, AWrongDimensionNamesBoth) {
    expect_refused(simulate(squeal_with("preload =", "preload = \"20 mm\"")), 2, {"case.toml:", "length", "force"});
}

TEST(BadInput, KineticFrictionAboveStaticIsRefused) {
    expect_refused(simulate(squeal_with("kinetic_friction =", "kinetic_friction = 0.9")), 2,
                   {"mu_d = 0.9", "mu_s = 0.8", "case.toml:"});
}

TEST(BadInput, ANegativeMassIsRefused) {
    expect_refused(simulate(squeal_with("mass =", "mass = -0.1")), 2, {"case.toml:", "mass", "above 0"});
}

TEST(BadInput, AStepBeyondTheStabilityLimitIsRefused) {
    expect_refused(simulate(squeal_with("engine =", "engine = \"beta_2\"\nstep = \"1 ms\"")), 2,
                   {"run.step", "stability limit"});
    const ScratchFolder folder;
    write_text(folder / "case.toml", squeal_with("engine =", "engine = \"beta_2\"\nstep = \"1 ms\""));
    expect_refused(run({"check", "case.toml"}, folder.path()), 2, {"run.step", "stability limit"});
}

TEST(BadInput, ATextThatIsNotTomlIsShownWithItsPlace) {
    expect_refused(simulate("[joint\nmass = 1"), 2, {"case.toml:1"});
}

TEST(BadInput, AFileThatIsNotThereIsAnIoError) {
    expect_refused(run({"simulate", "nowhere.toml"}), 5, {"nowhere.toml"});
}

TEST(BadInput, ATruncatedCsvIsShownWithItsPlace) {
    const ScratchFolder folder;
    std::string text = squeal_with("kind =", "kind = \"sampled\"\nfile = \"v.csv\"");
    for (const std::string line : {"amplitude =", "frequency ="}) {
        const std::size_t place = text.find("\n" + line);
        ASSERT_NE(place, std::string::npos);
        text.erase(place, text.find('\n', place + 1) - place);
    }
    write_text(folder / "case.toml", text);
    write_text(folder / "v.csv", "time,velocity\ns,m/s\n0,0.1\n0.5,");
    expect_refused(run({"simulate", "case.toml"}, folder.path()), 2, {"v.csv:4"});
    write_text(folder / "v.csv", "time,velocity\ns,m/s\n0,0.1\n1,0.1\n");
    EXPECT_EQ(run({"simulate", "case.toml"}, folder.path()).exit_code, 0);
}

TEST(BadInput, AnOverrideIsHeldToTheSameRules) {
    const std::string text = run({"init", "squeal"}).out;
    expect_refused(simulate(text, {"--set", "contact.preload=20 mm"}), 2, {"length", "force"});
    expect_refused(simulate(text, {"--set", "contact.prelaod=20"}), 2, {"prelaod", "contact.preload"});
    expect_refused(simulate(text, {"--set", "contact.preload"}), 2, {"contact.preload"});
}

TEST(BadInput, AllThatIsWrongIsToldInOneRun) {
    std::string text = squeal_with("preload =", "preload = \"20,5 N\"");
    const auto replace = [&](const std::string& from, const std::string& to) {
        const std::size_t place = text.find("\n" + from) + 1;
        text.replace(place, text.find('\n', place) - place, to);
    };
    replace("incidence_angle =", "incidence_angle = \"720 rpm\"");
    replace("damping =", "dampening = 1");
    replace("quiet_slip =", "quiet_slip = 2");
    expect_refused(simulate(text), 2,
                   {"Write \"20.5 N\"", "a frequency (Hz)", "unknown key plate.dampening", "verdict.quiet_slip = 2",
                    "Did you mean plate.damping?", "4 errors"});
}

// an init file changed by hand from one kind of drive to another is mended in one run
TEST(BadInput, AChangedKindOfDriveIsMendedInOneRun) {
    const std::string text = squeal_with("kind =", "kind = \"constant\"");
    expect_refused(simulate(text), 2,
                   {"missing key drive.velocity", "Write for example velocity = \"0.1 m/s\" in [drive]",
                    "warning: drive.amplitude", "warning: verdict.settling"});
    std::string mended = text;
    mended.replace(mended.find("#velocity"), 1, "");
    const Finished finished = simulate(mended);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_NE(finished.err.find("warning: drive.frequency means nothing for this case"), std::string::npos);
    EXPECT_EQ(finished.err.find("error"), std::string::npos) << finished.err;
}

TEST(BadInput, ManyErrorsAreCounted) {
    std::string text = "[joint]\n";
    for (int k = 0; k < 30; ++k)
        text += "nonsense_" + std::to_string(k) + " = 1\n";
    expect_refused(simulate(text), 2, {"nonsense_19", "and 11 more errors"});
}

TEST(BadInput, AnUnknownCommandOrOptionIsAUsageError) {
    expect_refused(run({"simulat", "x"}), 2, {"--help"});
    expect_refused(run({"simulate", "--colour"}), 2, {"--help"});
    expect_refused(run(std::vector<std::string>{}), 2, {"--help"});
}

TEST(BadInput, AStoreOfAnotherCaseIsRefusedByTheFirstDifference) {
    const ScratchFolder folder;
    write_text(folder / "chart.toml", run({"init", "noise-chart"}).out);
    const std::vector<std::string> small{"chart", "chart.toml",        "--out", "out",
                                         "--set", "chart.x.points=2",  "--set", "chart.y.points=2",
                                         "--set", "run.duration=0.01", "--set", "run.window=0.005"};
    ASSERT_EQ(run(small, folder.path()).exit_code, 0);
    const std::string csv = read_text(folder / "out/chart.csv");
    std::vector<std::string> other = small;
    other.insert(other.end(), {"--set", "contact.static_friction=0.9"});
    expect_refused(run(other, folder.path()), 2, {"contact.static_friction", "0.8", "0.9"});
    EXPECT_EQ(read_text(folder / "out/chart.csv"), csv);
}

TEST(BadInput, AFileThatIsNoStoreIsRefused) {
    const ScratchFolder folder;
    write_text(folder / "chart.toml", run({"init", "noise-chart"}).out);
    std::filesystem::create_directory(folder / "out");
    write_text(folder / "out/chart.sqlite", "this is no database, but it is long enough to be looked at as one");
    expect_refused(run({"chart", "chart.toml", "--out", "out"}, folder.path()), 2, {"chart.sqlite"});
}

TEST(BadInput, AFullDiskIsAnIoErrorAndLeavesNothingHalf) {
    const ScratchFolder folder;
    write_text(folder / "squeal.toml", run({"init", "squeal"}).out);
    const Finished finished =
        run(Launch{{"simulate", "squeal.toml", "--trace", "trace.csv"}, folder.path(), {}, 4096, {}});
    EXPECT_EQ(finished.exit_code, 5) << finished.err;
    EXPECT_NE(finished.err.find("trace.csv"), std::string::npos) << finished.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "trace.csv"));
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path()))
        ++files;
    EXPECT_EQ(files, 1U) << "a temporary file was left behind";
}

TEST(BadInput, AFullDiskUnderAStoreIsAnIoErrorAndTheSweepGoesOnLater) {
    const ScratchFolder folder;
    write_text(folder / "chart.toml", run({"init", "noise-chart"}).out);
    const std::vector<std::string> arguments{"chart", "chart.toml",        "--out", "out",
                                             "--set", "chart.x.points=24", "--set", "chart.y.points=24",
                                             "--set", "run.duration=1 ms", "--set", "run.window=0.5 ms"};
    const Finished full = run(Launch{arguments, folder.path(), {}, 65536, {}});
    EXPECT_EQ(full.exit_code, 5) << full.err;
    const Finished resumed = run(arguments, folder.path());
    EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
}

TEST(BadInput, AnEndedPipeIsNoError) {
    // /dev/full refuses every byte: the same path as a full disk behind a redirection
    EXPECT_EQ(run({"init", "squeal", "-o", "/dev/full"}).exit_code, 5);
}
