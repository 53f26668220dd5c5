// No request reaches a file: not by any spelling of a key, not by a preset, a name or a path.

#include "stridor/explorer/api.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "support/canary.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace stridor::explorer {
namespace {

using nlohmann::json;

// what may stand where it should not: control characters, blanks, quotes
std::vector<char> odd_bytes() {
    std::vector<char> bytes{' ', '"', '\'', '\\', '.', '\x7f'};
    for (char byte = 0; byte < 0x20; ++byte)
        bytes.push_back(byte);
    return bytes;
}

class FilesTest : public testing::Test {
protected:
    FilesTest() { world_.presets = paper_presets(); }

    Response post(const std::string& path, const json& body) {
        HttpRequest request;
        request.method = "POST";
        request.path = path;
        request.body = body.dump();
        return answer(world_, request, {});
    }

    // a request whose drive is sampled, so that its file would be opened
    void expect_refused(const std::string& key, const std::string& path = "/api/toml") {
        for (const std::string& file : {canary_.file(), canary_.pipe()}) {
            const json body{{"preset", "squeal"}, {"set", {"drive.kind=sampled", key + "=" + file}}};
            const Response response = post(path, body);
            EXPECT_EQ(response.status, 400) << body;
            EXPECT_EQ(response.body.find(support::Canary::mark), std::string::npos) << body << response.body;
            ASSERT_FALSE(canary_.was_opened()) << body << response.body;
        }
    }

    World world_;
    support::Canary canary_;
};

TEST_F(FilesTest, TheCanarySingsWhenOpened) {
    ASSERT_TRUE(canary_.is_watching());
    EXPECT_FALSE(canary_.was_opened());
    std::ifstream(canary_.file()).get();
    EXPECT_TRUE(canary_.was_opened());
    std::ifstream(canary_.pipe()).get();
    EXPECT_TRUE(canary_.was_opened());
}

TEST_F(FilesTest, NoByteAroundTheKeyOfAFileOpensIt) {
    const std::string key = "drive.file";
    expect_refused(key);
    for (const char byte : odd_bytes())
        for (std::size_t at = 0; at <= key.size(); ++at) {
            std::string odd = key;
            expect_refused(odd.insert(at, 1, byte));
            if (HasFatalFailure()) return;
        }
}

TEST_F(FilesTest, NoByteAroundAnyKeyOpensAFile) {
    for (const parameters::Field& field : parameters::fields()) {
        const std::string key = parameters::key_of(field);
        if (key == "title") continue;  // any text will do for it
        for (const char byte : odd_bytes())
            for (const std::size_t at : {std::size_t{0}, key.find('.'), key.find('.') + 1, key.size()}) {
                std::string odd = key;
                expect_refused(odd.insert(at, 1, byte));
                if (HasFatalFailure()) return;
            }
    }
}

TEST_F(FilesTest, NoAnswerOpensOne) {
    for (const char* path : {"/api/simulate", "/api/motion", "/api/chart", "/api/stability", "/api/toml", "/api/sound",
                             "/api/analysis", "/api/advice", "/api/report", "/api/share"})
        for (const char* key :
             {"drive.file", " drive.file", "drive.file ", "drive.file\n", "\rdrive.file", "drive.file\r\n",
              "\"drive.file\"", "\"drive\".\"file\"", "drive.'file'", "drive", "drive={file", "file"})
            expect_refused(key, path);
}

// two overrides in one text, a key that another text ends, a value with a line end in it
TEST_F(FilesTest, NoValueSmugglesAnotherKey) {
    for (const std::string& file : {canary_.file(), canary_.pipe()})
        for (const std::string& text :
             {"title=x\ndrive.file=" + file, "title=\"x\"\ndrive.file=\"" + file + "\"",
              "title=x\r\n[drive]\r\nfile=" + file, "contact.preload=20 N\ndrive.file=" + file,
              "drive={kind=\"sampled\",file=\"" + file + "\"}", "drive.file\t= " + file, "drive.fil\\u0065=" + file,
              "\"drive.fil\\u0065\"=" + file}) {
            const Response response =
                post("/api/simulate", {{"preset", "squeal"}, {"set", {"drive.kind=sampled", text}}});
            EXPECT_EQ(response.status, 400) << text;
            EXPECT_FALSE(canary_.was_opened()) << text;
        }
}

// the case that the program was started with may have a sampled drive: its file was read then, and is not again
TEST_F(FilesTest, ASampledPresetKeepsTheSamplesItCameWith) {
    std::string text = io::case_toml(parameters::paper_case(parameters::PaperCase::squeal), {io::Comments::none, ""});
    const std::size_t from = text.find("[drive]");
    text.replace(from, text.find("\n[", from) - from,
                 "[drive]\nkind = \"sampled\"\nfile = \"" + canary_.file() + "\"\n");
    Preset preset{"file", text, "case.toml"};
    const auto ask = [&](const std::vector<std::string>& set) {
        world_.presets = {preset};
        return post("/api/toml", {{"preset", "file"}, {"set", set}});
    };
    EXPECT_EQ(ask({}).status, 400) << "nothing was read when the program started";
    preset.samples_file = canary_.file();
    preset.samples = {{0.0, 0.5, 5.0}, {0.1, -0.1, 0.1}};
    EXPECT_EQ(ask({}).status, 200) << ask({}).body;
    EXPECT_EQ(ask({"drive.kind=constant", "drive.velocity=0.1"}).status, 200);
    EXPECT_EQ(ask({"drive.file=" + canary_.pipe()}).status, 400);
    EXPECT_FALSE(canary_.was_opened());
}

// rows of a table have a colon, and a file may have one, too; of several joints each has keys of its own
TEST_F(FilesTest, NoTableOpensOne) {
    parameters::Case several = parameters::paper_case(parameters::PaperCase::squeal);
    several.joints.push_back(several.joints.front());
    several.joints[0].name = "lip", several.joints[1].name = "foot";
    world_.presets.push_back({"several", io::case_toml(several), "several.toml"});
    for (const std::string& file : {canary_.file(), canary_.pipe()})
        for (const std::string& value : {file, file + ";", file + "; a: b", file + ": a", "./" + file + ";:"})
            for (const auto& [preset, joint] : {std::pair("squeal", ""), std::pair("several", "joint.foot.")})
                for (const auto& [key, choice] :
                     {std::pair("contact.friction_table", "contact.friction=table"),
                      std::pair("contact.pair", "contact.impact=plastic"),
                      std::pair(*joint == 0 ? "joint.axial_force" : "axial_force", "joint.stiffening=table")}) {
                    const std::string of_joint = *joint != 0 && std::string(choice).starts_with("joint.")
                                                     ? "joint.foot.stiffening=table"
                                                     : joint + std::string(choice);
                    const json body{{"preset", preset}, {"set", {of_joint, joint + std::string(key) + "=" + value}}};
                    const Response response = post("/api/toml", body);
                    EXPECT_EQ(response.status, 400) << body << response.body;
                    EXPECT_FALSE(canary_.was_opened()) << body;
                    EXPECT_EQ(response.body.find(support::Canary::mark), std::string::npos) << body;
                }
}

// tables were read when the program started, and are not again
TEST_F(FilesTest, APresetKeepsTheTablesItCameWith) {
    const support::ScratchFolder folder;
    storage::write_file(folder / "rubber.csv", "speed,friction\n0,0.8\n0.1,0.6\n10,0.6\n");
    storage::write_file(folder / "lip.csv", "deflection,force\n0,0\n1,2e6\n");
    parameters::Case c = parameters::paper_case(parameters::PaperCase::squeal);
    c.contact().friction = parameters::FrictionKind::table;
    c.contact().friction_table.file = "rubber.csv";
    c.joint().stiffening = parameters::Stiffening::table;
    c.joint().axial_force.file = "lip.csv";
    world_.presets.push_back(preset_of({io::case_toml(c), folder / "case.toml", {}}, {}));
    for (const char* file : {"rubber.csv", "lip.csv"})
        std::filesystem::remove(folder / file);
    const Response response = post("/api/toml", {{"preset", "file"}, {"set", {"contact.preload=30"}}});
    EXPECT_EQ(response.status, 200) << response.body;
}

TEST_F(FilesTest, NoPresetNamesOne) {
    for (const std::string& file : {canary_.file(), canary_.pipe(), "file://" + canary_.file()})
        EXPECT_EQ(post("/api/simulate", {{"preset", file}}).status, 400);
    EXPECT_FALSE(canary_.was_opened());
}

}  // namespace
}  // namespace stridor::explorer
