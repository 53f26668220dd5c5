// Many recordings by ear from outside: a row each, whatever becomes of the others.

#include "support/json_of.hpp"
#include "support/lines.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using nlohmann::json;
using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::lines_of;
using stridor::support::read_text;
using stridor::support::run;
using stridor::support::ScratchFolder;
using stridor::support::write_text;

namespace {

// a second of a sound as a table with a rate of 16 kHz
void write_sound(const std::filesystem::path& file, const std::function<double(double)>& at) {
    std::ostringstream text;
    text << "time [s],sound\n";
    for (int n = 0; n < 16000; ++n)
        text << n / 16000.0 << "," << at(n / 16000.0) << "\n";
    write_text(file, text.str());
}

double tone(double time) {
    return std::sin(6.283185307179586 * 1000.0 * time);
}

double silence(double) {
    return 0.0;
}

// two sounds in three folders, two files that are no sounds, one that is not looked at
void fill(const ScratchFolder& folder) {
    std::filesystem::create_directories(folder / "takes/late");
    write_sound(folder / "takes/tone.csv", tone);
    write_sound(folder / "takes/late/silence.csv", silence);
    write_text(folder / "takes/late/text.wav", "RIFF no sound");
    write_text(folder / "takes/late/void.flac", "");
    write_text(folder / "takes/notes.md", "loud");
    write_sound(folder / "alone.csv", tone);
}

std::map<std::string, json> by_file(const json& document) {
    std::map<std::string, json> rows;
    for (const json& row : document["recordings"])
        rows[row["file"]] = row;
    return rows;
}

}  // namespace

TEST(ClassifyMany, HasARowForEachAndTellsWhatIsDamaged) {
    const ScratchFolder folder;
    fill(folder);
    const Finished finished =
        run({"classify", "takes", "alone.csv", "nowhere.wav", "--json", "--csv", "rows.csv"}, folder.path());
    EXPECT_EQ(finished.exit_code, 2);
    EXPECT_NE(finished.err.find("3 of 6 recordings could not be heard"), std::string::npos) << finished.err;
    const json document = json_of(finished.out);
    EXPECT_EQ(document["schema"], "stridor.classified/1");
    std::map<std::string, json> rows = by_file(document);
    ASSERT_EQ(rows.size(), 6u);
    EXPECT_EQ(rows["takes/tone.csv"]["category"], "squeal");
    EXPECT_NEAR(rows["takes/tone.csv"]["dominant_frequency"].get<double>(), 1000.0, 5.0);
    EXPECT_EQ(rows["takes/late/silence.csv"]["category"], "none");
    for (const char* damaged : {"takes/late/text.wav", "takes/late/void.flac", "nowhere.wav"}) {
        EXPECT_FALSE(rows[damaged].contains("category")) << damaged;
        EXPECT_NE(rows[damaged]["error"].get<std::string>().find(damaged), std::string::npos) << rows[damaged];
    }
    // the table says the same
    const std::vector<std::string> table = lines_of(read_text(folder / "rows.csv"));
    ASSERT_EQ(table.size(), 8u);
    EXPECT_TRUE(table[1].starts_with("file,category,probability,share_none,")) << table[1];
    for (std::size_t k = 2; k < table.size(); ++k) {
        const std::string file = table[k].substr(0, table[k].find(','));
        const std::string category = rows[file].value("category", "");
        EXPECT_TRUE(table[k].starts_with(file + "," + category + ",")) << table[k];
    }
}

TEST(ClassifyMany, SaysOfEachWhatItSaysOfOneAlone) {
    const ScratchFolder folder;
    fill(folder);
    const json alone = json_of(run({"classify", "alone.csv", "--json"}, folder.path()).out);
    const Finished finished = run({"classify", "alone.csv", "takes/tone.csv", "--json"}, folder.path());
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    std::map<std::string, json> rows = by_file(json_of(finished.out));
    const json& verdict = alone["channels"][0]["verdict"];
    for (const char* key : {"category", "probability", "shares", "reasons"})
        EXPECT_EQ(rows["alone.csv"][key], verdict[key]) << key;
}

TEST(ClassifyMany, PrintsATable) {
    const ScratchFolder folder;
    fill(folder);
    const Finished finished = run({"classify", "takes"}, folder.path());
    EXPECT_EQ(finished.exit_code, 2);
    const std::vector<std::string> lines = lines_of(finished.out);
    ASSERT_EQ(lines.size(), 8u) << finished.out;
    EXPECT_EQ(lines[6], "4 recordings: none 1 squeal 1 not heard 2");
    // the times of both tables are rounded
    EXPECT_TRUE(lines[7].starts_with("note, 2 recordings: the step ")) << lines[7];
    EXPECT_TRUE(lines[4].starts_with("takes/tone.csv ")) << lines[4];
}

TEST(ClassifyMany, RefusesSlipsOfThePenOnce) {
    const ScratchFolder folder;
    fill(folder);
    const auto refused = [&](std::vector<std::string> words, const std::string& reason) {
        words.insert(words.begin(), "classify");
        const Finished finished = run(words, folder.path());
        EXPECT_EQ(finished.exit_code, 2);
        EXPECT_EQ(finished.out, "");
        EXPECT_NE(finished.err.find(reason), std::string::npos) << finished.err;
    };
    refused({"takes", "--set", "squeal_regularty=0.7"}, "squeal_regularity");
    refused({"takes", "--rate", "0 Hz"}, "no sampling rate");
    std::filesystem::create_directories(folder / "bare");
    write_text(folder / "bare/notes.md", "loud");
    refused({"bare"}, "there is no recording in bare");
}

// a tone beside a softer channel in which it is not, as a microphone on the other side of a door
TEST(ClassifyMany, NamesTheChannelThatDecidesAndWhatTheOtherIs) {
    const ScratchFolder folder;
    std::ostringstream text;
    text << "time [s],near,far\n";
    std::mt19937 hiss(7);
    for (int n = 0; n < 16000; ++n)
        text << n / 16000.0 << "," << tone(n / 16000.0) << ","
             << (n % 4000 < 40 ? 0.1 : 0.001 * static_cast<double>(hiss() % 7)) << "\n";
    write_text(folder / "pair.csv", text.str());
    const Finished alone = run({"classify", "pair.csv"}, folder.path());
    EXPECT_NE(alone.out.find("the verdict rests on channel 1, the loudest: squeal\nchannel 2 is none"),
              std::string::npos)
        << alone.out;
    const json rows = json_of(run({"classify", "pair.csv", "pair.csv", "--json"}, folder.path()).out)["recordings"];
    EXPECT_EQ(rows[0]["channel"], 1);
    EXPECT_EQ(rows[0]["channels"], 2);
    EXPECT_TRUE(rows[0]["reasons"].back().get<std::string>().starts_with("channel 2 is none")) << rows[0];
    EXPECT_EQ(rows[0]["other_channels"][0]["channel"], 2);
    EXPECT_EQ(rows[0]["other_channels"][0]["category"], "none");
    const Finished table = run({"classify", "pair.csv", "pair.csv", "--csv", "rows.csv"}, folder.path());
    EXPECT_NE(table.out.find("2 recordings: squeal 2; further channels differ: none 2\n"), std::string::npos)
        << table.out;
    EXPECT_NE(read_text(folder / "rows.csv").find(",2 none"), std::string::npos);
    // of two that are heard alike there is nothing to say
    const json same =
        json_of(run({"classify", "pair.csv", "pair.csv", "--channel", "near", "--json"}, folder.path()).out);
    EXPECT_EQ(same["recordings"][0]["reasons"].dump().find("channel"), std::string::npos);
}

// rules judge motions and forces, the ear what is heard through air: a threshold of the others is set in vain
TEST(Classify, SaysOfAThresholdThatItChangesNothing) {
    const ScratchFolder folder;
    fill(folder);
    const auto told = [&](std::vector<std::string> words) {
        words.insert(words.begin(), "classify");
        return run(words, folder.path()).err;
    };
    const std::string vain = "changes nothing here";
    for (const char* file : {"alone.csv", "takes"}) {
        EXPECT_NE(told({file, "--set", "squeal_regularity=0.9"}).find("squeal_regularity " + vain), std::string::npos);
        EXPECT_EQ(told({file, "--set", "certainty=0.6"}).find(vain), std::string::npos);
        EXPECT_EQ(told({file, "--set", "quiet_depth=20"}).find(vain), std::string::npos);
        const auto motion = [&](const char* set) { return told({file, "--full-scale", "1 m/s", "--set", set}); };
        EXPECT_EQ(motion("squeal_regularity=0.9").find(vain), std::string::npos);
        EXPECT_NE(motion("certainty=0.6").find("certainty " + vain), std::string::npos);
    }
}

TEST(Classify, CallsHissNoSilenceAndSilenceNoVerdict) {
    const ScratchFolder folder;
    std::string hiss = "time [s],hiss\n";
    std::string nothing = "time [s],nothing\n";
    std::mt19937 random(3);
    for (int n = 0; n < 16000; ++n) {
        hiss +=
            std::to_string(n / 16000.0) + "," + std::to_string(static_cast<double>(random() % 2001) / 1e4 - 0.1) + "\n";
        nothing += std::to_string(n / 16000.0) + ",0\n";
    }
    write_text(folder / "hiss.csv", hiss);
    write_text(folder / "nothing.csv", nothing);
    EXPECT_EQ(run({"classify", "hiss.csv"}, folder.path()).out.find("silence"), std::string::npos);
    const std::string told = run({"classify", "nothing.csv"}, folder.path()).out;
    EXPECT_NE(told.find("there is nothing to hear"), std::string::npos) << told;
    EXPECT_EQ(told.find("with "), std::string::npos) << told;
}
