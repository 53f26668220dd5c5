// A case with a structure of its own, in the page: what of it is sent, what may vary, and which files stay closed.

#include "stridor/explorer/api.hpp"
#include "stridor/explorer/served_world.hpp"
#include "stridor/integration/cost.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "support/canary.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace stridor::explorer {
namespace {

using nlohmann::json;

constexpr const char* block =
    "[structure]\nmass = \"MASS\"\nstiffness = [[1e5, -4e4], [-4e4, 2e5]]\nrows = [\"x\", \"y\"]\n"
    "damping_ratio = 0.01\n"
    "[[structure.contact]]\nname = \"foot\"\nnormal = \"y\"\ntangent = \"x\"\n"
    "[contact]\npreload = 5\nstatic_friction = 0.8\nkinetic_friction = 0.3\n"
    "[drive]\nkind = \"constant\"\nvelocity = 0.02\n[run]\nduration = 0.2\n";

Response posted(const World& world, const std::string& path, const json& body) {
    HttpRequest request;
    request.method = "POST";
    request.path = path;
    request.body = body.dump();
    return answer(world, request, {});
}

World world_with(const io::TomlSource& source) {
    World world;
    world.presets = paper_presets();
    world.presets.insert(world.presets.begin(), preset_of(source));
    return world;
}

json of_file(std::vector<std::string> set = {}) {
    return {{"preset", "file"}, {"set", std::move(set)}};
}

json simulated(const World& world, std::vector<std::string> set = {}) {
    const Response response = posted(world, "/api/simulate", of_file(std::move(set)));
    EXPECT_EQ(response.status, 200) << response.body;
    return json::parse(response.body);
}

std::string refusal_of(const World& world, const std::string& path, const json& body) {
    const Response response = posted(world, path, body);
    EXPECT_EQ(response.status, 400) << response.body;
    return json::parse(response.body)["error"]["what"];
}

/// The header of an answer with a motion, and its columns by name.
struct SentMotion {
    json header;
    std::map<std::string, std::vector<float>> columns{};
};

SentMotion motion_of(const World& world, const json& body) {
    const Response response = posted(world, "/api/motion", body);
    EXPECT_EQ(response.status, 200) << response.body.substr(0, 300);
    std::uint32_t length = 0;
    std::memcpy(&length, response.body.data(), sizeof length);
    SentMotion motion{json::parse(response.body.substr(4, length))};
    std::size_t at = 4 + length;
    const std::size_t samples = motion.header["samples"];
    for (const json& column : motion.header["columns"]) {
        std::vector<float> values(samples);
        std::memcpy(values.data(), response.body.data() + at, samples * sizeof(float));
        motion.columns[column["name"]] = std::move(values);
        at += (samples * sizeof(float) + 7) / 8 * 8;
    }
    return motion;
}

TEST(StructureInThePage, BeginsWithItsFieldsAndAChartOverThem) {
    const World world = world_with({io::ready_file("chain"), "chain.toml", {}});
    HttpRequest request;
    request.method = "GET";
    request.path = "/api/start";
    const json preset = json::parse(answer(world, request, {}).body)["presets"][0];
    EXPECT_EQ(preset["name"], "file");
    EXPECT_EQ(preset["case"]["structure"]["coupling"], 1.2);
    EXPECT_EQ(preset["case"]["structure"]["contacts"].size(), 2U);
    EXPECT_EQ(preset["chart"]["x"]["parameter"], "contact.preload");
    EXPECT_EQ(preset["chart"]["y"]["parameter"], "contact.kinetic_friction");
    EXPECT_EQ(preset["chart"]["y"]["to"], 1.0);  // its static friction
}

TEST(StructureInThePage, VariesWhatItsBuilderTakes) {
    const World world = world_with({io::ready_file("chain"), "chain.toml", {"run.duration=20", "run.window=20"}});
    const json own = simulated(world)["case"]["structure"];
    const json other = simulated(world, {"structure.coupling=0.5"})["case"]["structure"];
    EXPECT_EQ(other["coupling"], 0.5);
    EXPECT_NE(own["content"], other["content"]);
    EXPECT_NE(refusal_of(world, "/api/simulate", of_file({"structure.frequency=100"})).find("structure.frequency"),
              std::string::npos);
}

TEST(StructureInThePage, SendsWhatItsContactsDo) {
    const World world =
        world_with({io::ready_file("chain"), "chain.toml", {"run.duration=20", "run.window=20", "run.initial=stuck"}});
    json body = of_file();
    body["interval"] = 0.01;
    const SentMotion motion = motion_of(world, body);
    EXPECT_EQ(motion.header["contacts"][1]["name"], "block2");
    EXPECT_FALSE(motion.header.contains("outline"));
    ASSERT_TRUE(motion.columns.contains("x_block1"));
    EXPECT_TRUE(motion.columns.contains("normal_force_2"));
    // until it slips it sticks to the belt
    EXPECT_NEAR(motion.columns.at("x_block1")[50], 0.05F, 1e-6F);
    EXPECT_NEAR(motion.columns.at("x_block2_velocity")[50], 0.1F, 1e-6F);
    EXPECT_NEAR(motion.columns.at("normal_force_1")[50], 1.0F, 1e-6F);
}

TEST(StructureInThePage, SendsTheShapeOfAStringWhereTheBowIs) {
    const World world = world_with({io::ready_file("string"), "string.toml", {"run.duration=0.1", "run.window=0.1"}});
    json body = of_file();
    body["interval"] = 1e-4;
    const SentMotion motion = motion_of(world, body);
    const json& outline = motion.header["outline"];
    EXPECT_EQ(outline.front()[2], 0.0);
    EXPECT_EQ(outline.back()[2], 0.5);
    // the bow at 0.13 of the length stands between the points 6 and 7 of 41, which are straight there or nearly
    const float before = motion.columns.at("outline_6_x")[300], after = motion.columns.at("outline_7_x")[300];
    EXPECT_NEAR(motion.columns.at("x1")[300], 0.8F * before + 0.2F * after, 1e-5F);
    EXPECT_FALSE(motion.columns.contains("outline_6_y"));
}

TEST(StructureInThePage, SendsFewerSamplesOfManyContacts) {
    std::string text = io::ready_file("chain");
    text.replace(text.find("blocks = 2"), 10, "blocks = 60");
    const World world = world_with({text, "chain.toml", {"run.duration=0.5", "run.window=0.5"}});
    const SentMotion motion = motion_of(world, of_file());
    const auto columns = static_cast<double>(motion.columns.size());
    EXPECT_GT(columns, 400.0);
    EXPECT_LE(columns * static_cast<double>(motion.header["samples"]), 1.21e7);
}

TEST(StructureInThePage, IsNotReadAgainAndNamesNoFile) {
    const support::ScratchFolder folder;
    const std::string mass = (folder / "mass.csv").string();
    std::ofstream(mass) << "0.1,0\n0,0.1\n";
    std::string text = block;
    text.replace(text.find("MASS"), 4, mass);
    const World world = world_with({text, "own.toml", {}});
    const json before = simulated(world);
    std::filesystem::remove(mass);
    EXPECT_EQ(simulated(world)["phases"], before["phases"]);

    support::Canary canary;
    ASSERT_TRUE(canary.is_watching());
    for (const std::string& file : {canary.file(), canary.pipe()})
        for (const char* key : {"structure.file", "structure.mass", "structure.damping", "structure.labels",
                                "structure.contacts", "structure.contact.1.node", "structure", "structure.builder",
                                "structure.rows", "structure.blocks", " structure.file ", "structure . file"})
            for (const char* path : {"/api/simulate", "/api/toml", "/api/motion", "/api/stability"}) {
                const Response response = posted(world, path, of_file({std::string(key) + "=" + file}));
                EXPECT_EQ(response.status, 400) << key << response.body.substr(0, 300);
                EXPECT_EQ(response.body.find(support::Canary::mark), std::string::npos) << key;
                ASSERT_FALSE(canary.was_opened()) << key;
            }
}

TEST(StructureInThePage, TakesTheNumbersOfItsBuilderInAnyUnit) {
    const World world = world_with({io::ready_file("string"), "string.toml", {}});
    const Response response = posted(world, "/api/value", {{"key", "structure.length"}, {"text", "32.5 cm"}});
    EXPECT_EQ(json::parse(response.body)["value"], 0.325);
    EXPECT_NE(refusal_of(world, "/api/value", {{"key", "structure.length"}, {"text", "3 kg"}}).find("structure.length"),
              std::string::npos);
}

TEST(StructureInThePage, DoesNotTravelInALink) {
    const World world = world_with({io::ready_file("chain"), "chain.toml", {}});
    EXPECT_EQ(refusal_of(world, "/api/share", of_file()), "a structure of its own does not travel in a link");
}

TEST(StructureInThePage, MayTakeMinutesWhereItIsSlow) {
    const World world = world_with({io::ready_file("chain"), "chain.toml", {}});  // 200 s
    EXPECT_EQ(simulated(world)["phases"][0]["verdict"]["category"], "creak");
    EXPECT_EQ(refusal_of(world, "/api/simulate", of_file({"run.duration=1e9", "run.window=1e9"})),
              "run.duration = 1e+09 s is too long to be explored");
}

// measured: of a string of 41 rows one spring that is not linear doubles the time, and four take five times as long
TEST(StructureInThePage, HasACoarserChartWithSpringsThatAreNotLinear) {
    const auto points_of = [](const std::string& text) {
        const Preset preset = preset_of({text, "case.toml", {}});
        return std::pair(preset.study->x.points, integration::cost(preset.study->base).seconds);
    };
    std::string text = io::ready_file("string"), row = "direction = [0, 0, 0, 1";
    for (int k = 4; k < 41; ++k)
        row += ", 0";
    const auto spring = [&](int number, const std::string& law) {
        return "\n[[structure.spring]]\nname = \"s" + std::to_string(number) + "\"\n" + row + "]\n" + law;
    };
    const auto [points, seconds] = points_of(text);
    EXPECT_EQ(points_of(text + spring(1, "stiffness = 1\n")).first, points) << "it is linear";
    const auto [points_with_one, seconds_with_one] = points_of(text + spring(1, "cubic = 1e9\n"));
    EXPECT_LT(points_with_one, points);
    EXPECT_GT(seconds_with_one, 1.5 * seconds);
    EXPECT_LT(seconds_with_one, 5.0 * seconds);
    for (int number = 1; number <= 4; ++number)
        text += spring(number, "cubic = 1e9\n");
    const auto [points_with_four, seconds_with_four] = points_of(text);
    EXPECT_LE(points_with_four, points_with_one);
    EXPECT_GT(seconds_with_four, 2.5 * seconds);
    EXPECT_LT(seconds_with_four, 10.0 * seconds);
}

// one run of Table 1's squeal takes 3 ms, and 0.1 s with a joint that stiffens
TEST(Preset, OfAJointThatStiffensHasACoarserChart) {
    const auto points_of = [](const std::string& kind, const std::string& joint, double cubic) {
        std::vector<std::string> set;
        if (cubic != 0.0)
            set = {joint + ".stiffening=cubic", joint + ".axial_cubic=" + std::to_string(cubic),
                   joint + ".flexural_cubic=0"};
        return preset_of({io::ready_file(kind), kind, set}).study->x.points;
    };
    EXPECT_EQ(points_of("squeal", "joint", 0.0), 64);
    EXPECT_LT(points_of("squeal", "joint", 1e12), 40);
    EXPECT_EQ(points_of("two-lips", "joint.upper", 0.0), 16);
    EXPECT_LE(points_of("two-lips", "joint.upper", 1e12), 16);
}

TEST(StructureInThePage, OfManyRowsLeavesItsStabilityToTheCommandLine) {
    std::string text = io::ready_file("chain");
    text.replace(text.find("blocks = 2"), 10, "blocks = 100");
    const World world = world_with({text, "chain.toml", {}});
    EXPECT_EQ(refusal_of(world, "/api/stability", of_file()),
              "the stability of 200 rows is not computed while you wait");
}

}  // namespace
}  // namespace stridor::explorer
