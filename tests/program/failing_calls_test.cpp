// Every command that writes, on a disk that fails at the n-th call, for all n: the error is said, no file is half
// there, what was there before is whole, and the same command again succeeds.
//
// STRIDOR_FAILING_STEP=k takes every k-th n only, from another beginning for each fault: usually as many as there are
// faults, so that each call fails once, by one of them (checked builds: every 23rd). 1 takes all.

#include "support/effort.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <iterator>
#include <map>
#include <string_view>

namespace stridor {
namespace {

namespace fs = std::filesystem;
using support::Finished;
using support::Launch;
using support::read_text;
using support::ScratchFolder;
using support::write_text;

using Arguments = std::vector<std::string>;
using Files = std::map<std::string, std::string>;  // bytes by name

struct Fault {
    const char* name;
    int error;   // errno; 0: half of the bytes are written; below 0: the process dies by this signal
    long times;  // calls that fail
};

constexpr long for_ever = 1000000;
constexpr const char* listing = "library list";  // what stands for a library among the files
const Fault faults[] = {
    {"FullOnce", ENOSPC, 1},       {"FullForEver", ENOSPC, for_ever},
    {"BrokenOnce", EIO, 1},        {"BrokenForEver", EIO, for_ever},
    {"InterruptedOnce", EINTR, 1}, {"InterruptedOften", EINTR, 50},
    {"ShortOnce", 0, 1},           {"ShortForEver", 0, for_ever},
    {"Killed", -SIGKILL, 1},
};

struct Command {
    const char* name;
    Arguments arguments;             // run in the folder "work"
    Arguments before;                // leaves "work" as it is before; empty: nothing is there
    std::vector<std::string> whole;  // files that are there as a whole, old or new, or not at all
    std::string program{};           // another one than stridor
};

const Arguments small_chart{"chart",     "pair.toml",
                            "--out",     "out",
                            "--threads", "1",
                            "--set",     "chart.x.points=2",
                            "--set",     "chart.y.points=2",
                            "--set",     "run.duration=0.02",
                            "--set",     "run.window=0.01"};

// a library's own tests look into its database; what its users see is told by `library list`
const Command commands[] = {
    {"Chart",
     small_chart,
     {},
     {"out/chart.toml", "out/chart.csv", "out/boundaries.csv", "out/chart.nc", "out/chart.png", "out/chart.svg"}},
    {"TraceCsv",
     {"simulate", "squeal.toml", "--set", "run.window=0.3", "--set", "run.duration=0.4", "--trace", "t.csv",
      "--history", "h.csv"},
     {"simulate", "squeal.toml", "--set", "run.window=0.3", "--set", "run.duration=0.3", "--trace", "t.csv"},
     {"t.csv", "h.csv"}},
    {"TraceNetcdf",
     {"simulate", "squeal.toml", "--set", "run.window=0.3", "--set", "run.duration=0.4", "--trace", "t.nc"},
     {"simulate", "squeal.toml", "--set", "run.window=0.3", "--set", "run.duration=0.3", "--trace", "t.nc"},
     {"t.nc"}},
    {"Figure",
     {"simulate", "squeal.toml", "--set", "run.window=0.3", "--set", "run.duration=0.4", "--figure", "f.png"},
     {},
     {"f.png"}},
    {"Init", {"init", "squeal", "-o", "new.toml"}, {"init", "creak", "-o", "new.toml"}, {"new.toml"}},
    {"Listen",
     {"listen", "squeal.toml", "--set", "run.window=0.3", "--set", "run.duration=0.4", "--out", "s.wav"},
     {},
     {"s.wav", "s.wav.json"}},
    {"ConvertToWav", {"convert", "sound.wav", "c.wav"}, {}, {"c.wav"}},
    {"ConvertToCsv", {"convert", "sound.wav", "c.csv"}, {}, {"c.csv"}},
    {"ConvertToUff", {"convert", "sound.wav", "c.uff"}, {"convert", "other.wav", "c.uff"}, {"c.uff"}},
    {"LibraryBegin", {"library", "add", "sound.wav", "--library", "l.sqlite"}, {}, {}},
    {"LibraryAdd",
     {"library", "add", "sound.wav", "--library", "l.sqlite"},
     {"library", "add", "other.wav", "--library", "l.sqlite"},
     {}},
    {"LibraryImport",
     {"library", "import", "archive.tar", "--library", "l.sqlite"},
     {"library", "add", "other.wav", "--library", "l.sqlite"},
     {}},
    {"LibraryExport",
     {"library", "export", "new.tar", "--library", "l.sqlite"},
     {"library", "add", "other.wav", "--library", "l.sqlite"},
     {"new.tar"}},
    // a chart that does not fit into memory: HDF5 writes it in a process of its own
    {"LargeChart", {"large.nc"}, {}, {"large.nc"}, STRIDOR_LARGE_CHART},
};

std::ostream& operator<<(std::ostream& out, const Fault& fault) {
    return out << fault.name;
}

std::ostream& operator<<(std::ostream& out, const Command& command) {
    return out << command.name;
}

class FailingCalls : public testing::TestWithParam<std::tuple<Command, Fault>> {
protected:
    const Command& command() const { return std::get<0>(GetParam()); }
    const Fault& fault() const { return std::get<1>(GetParam()); }

    // what a command finds and leaves, made once in a process for all its faults
    struct Place {
        ScratchFolder folder;  // "before", and "work" anew for each try
        Files before;
        Files after;
    };

    void SetUp() override {
        static std::map<std::string, Place> places;
        const bool is_new = !places.contains(command().name);
        place_ = &places[command().name];
        if (is_new) prepare();
    }

    void prepare() {
        fs::create_directories(folder() / "before/tmp");
        start_in("before", {"init", "squeal", "-o", "squeal.toml"});
        start_in("before", {"init", "noise-chart", "-o", "pair.toml"});
        for (const auto& [file, duration] : {std::pair("sound.wav", "0.3"), std::pair("other.wav", "0.35")})
            start_in("before", {"listen", "squeal.toml", "--set", "run.window=0.3", "--set",
                                std::string("run.duration=") + duration, "--out", file});
        start_in("before", {"library", "add", "sound.wav", "--library", "given.sqlite"});
        start_in("before", {"library", "export", "archive.tar", "--library", "given.sqlite"});
        if (!command().before.empty()) start_in("before", command().before);
        place_->before = seen("before");
        begin_anew();
        start_in("work", command().arguments);
        place_->after = seen("work");
    }

    void start_in(const std::string& place, const Arguments& arguments) const {
        const Finished finished = run_in(place, arguments, {});
        ASSERT_EQ(finished.exit_code, 0) << finished.err;
    }

    Finished run_in(const std::string& place, const Arguments& arguments,
                    std::vector<std::pair<std::string, std::string>> environment) const {
        environment.emplace_back("TMPDIR", (folder() / place / "tmp").string());
        const bool is_other = !command().program.empty() && arguments == command().arguments;
        return support::run(Launch{
            arguments, folder() / place, {}, std::nullopt, environment, is_other ? command().program : std::string()});
    }

    void begin_anew() const {
        fs::remove_all(folder() / "work");
        fs::copy(folder() / "before", folder() / "work", fs::copy_options::recursive);
    }

    Files files_in(const std::string& place) const {
        Files files;
        for (const std::string& name : command().whole)
            if (fs::exists(folder() / place / name)) files[name] = read_text(folder() / place / name);
        return files;
    }

    // whatever a user can see
    Files seen(const std::string& place) const {
        Files files = files_in(place);
        if (fs::exists(folder() / place / "l.sqlite"))
            files[listing] = run_in(place, {"library", "list", "--json", "--library", "l.sqlite"}, {}).out;
        return files;
    }

    // temporaries and journals
    std::string leftovers() const {
        std::string found;
        for (const auto& each : fs::recursive_directory_iterator(folder() / "work")) {
            const std::string name = each.path().filename().string();
            const bool is_left = name.starts_with(".stridor-") || name.ends_with("-journal") ||
                                 name.ends_with(".part") || name.ends_with(".marker") || name.starts_with("stridor-");
            if (is_left) found += " " + name;
        }
        return found;
    }

    // nothing if the command made fewer calls than n
    std::optional<Finished> fail_at(long n) {
        begin_anew();
        fs::remove(folder() / "report");
        const Finished finished = run_in("work", command().arguments,
                                         {{"LD_PRELOAD", STRIDOR_FAILING_CALLS},
                                          {"ASAN_OPTIONS", "strict_string_checks=1:verify_asan_link_order=0"},
                                          {"FAILING_BELOW", (folder() / "work").string()},
                                          {"FAILING_AT", std::to_string(n)},
                                          {"FAILING_WITH", std::to_string(fault().error)},
                                          {"FAILING_TIMES", std::to_string(fault().times)},
                                          {"FAILING_REPORT", (folder() / "report").string()}});
        if (!fs::exists(folder() / "report")) return std::nullopt;
        return finished;
    }

    // names what failed: one of its files, or where temporary ones lie
    bool names_a_file(const std::string& message) const {
        for (const char* part :
             {"out/",     "out (",       "out\"",     "t.csv",       "t.nc",      "h.csv",         "f.png",
              "new.",     "s.wav",       "c.wav",     "c.csv",       "c.uff",     "l.sqlite",      "l.audio",
              "large.nc", "archive.tar", "sound.wav", "squeal.toml", "pair.toml", "temporary file"})
            if (message.find(part) != std::string::npos) return true;
        return false;
    }

    const ScratchFolder& folder() const { return place_->folder; }
    const Files& before() const { return place_->before; }
    const Files& after() const { return place_->after; }

private:
    Place* place_ = nullptr;
};

bool has(const Files& files, const std::string& name, const std::string& bytes) {
    const auto found = files.find(name);
    return found != files.end() && found->second == bytes;
}

constexpr long closest = 3;  // steps that leave out no kind of call
constexpr long usual = std::size(faults);

long step() {
    const char* given = std::getenv("STRIDOR_FAILING_STEP");
    return given != nullptr ? std::atol(given) : support::effort(usual, 23L);
}

// another beginning for each fault
long first_of(const Fault& fault) {
    return std::find_if(std::begin(faults), std::end(faults),
                        [&](const Fault& each) { return std::string_view(each.name) == fault.name; }) -
           std::begin(faults);
}

TEST_P(FailingCalls, LeaveOldOrNewAndSayWhy) {
    long failed = 0;
    long tried = 0;
    for (long n = 1 + first_of(fault()) % step();; n += step(), ++tried) {
        const std::optional<Finished> finished = fail_at(n);
        if (!finished) break;
        const std::string what = command().name + std::string(" ") + fault().name + " at call " + std::to_string(n) +
                                 " (" + read_text(folder() / "report").substr(0, 300) + ") " + finished->err;
        const bool is_killed = fault().error < 0 && finished->signal == -fault().error;
        ASSERT_TRUE(is_killed || finished->exit_code == 0 || finished->exit_code == 5) << finished->exit_code << what;
        if (finished->exit_code == 5) {
            ++failed;
            EXPECT_NE(finished->err.find("error: "), std::string::npos) << what;
            EXPECT_TRUE(names_a_file(finished->err.substr(finished->err.find("error: ")))) << what;
        }
        if (finished->exit_code != 0) {
            const Files left = files_in("work");
            for (const auto& [name, bytes] : left)
                ASSERT_TRUE(has(before(), name, bytes) || has(after(), name, bytes)) << name << what;
            for (const auto& [name, bytes] : before())
                ASSERT_TRUE(left.contains(name) || name == listing) << name << what;
        } else {
            ASSERT_EQ(seen("work"), after()) << what;
        }
        // what failed, or left something, is run once more
        if (finished->exit_code == 0 && leftovers().empty()) continue;
        Finished again = run_in("work", command().arguments, {});
        // a process that wrote for the killed one may have lived a moment longer
        for (int k = 0; is_killed && !leftovers().empty() && k < 20; ++k)
            again = run_in("work", command().arguments, {});
        ASSERT_EQ(again.exit_code, 0) << again.err << what;
        ASSERT_EQ(seen("work"), after()) << what;
        ASSERT_EQ(leftovers(), "") << what;
    }
    RecordProperty("calls", std::to_string(tried));
    // the disk was in the way at all; one call alone may be one that is tried again, or whose failure harms nothing
    const bool must_fail = step() <= closest || (step() <= usual && fault().times == for_ever);
    if (must_fail && (fault().error == EIO || fault().error == ENOSPC)) {
        EXPECT_GT(failed, 0);
    }
}

std::string name_of(const testing::TestParamInfo<std::tuple<Command, Fault>>& info) {
    return std::get<0>(info.param).name + std::string(std::get<1>(info.param).name);
}

INSTANTIATE_TEST_SUITE_P(Of, FailingCalls, testing::Combine(testing::ValuesIn(commands), testing::ValuesIn(faults)),
                         name_of);

}  // namespace
}  // namespace stridor
