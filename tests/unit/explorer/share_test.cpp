// What leaves the page and comes back: texts with units, links that hold a whole case, the chart of a file.

#include "stridor/explorer/api.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace stridor::explorer {
namespace {

using nlohmann::json;
using parameters::Case;
using parameters::Field;
using parameters::PaperCase;

World world_with(const Case& c) {
    World world;
    world.presets = paper_presets();
    world.presets.insert(world.presets.begin(), {"file", io::case_toml(c), "seal.toml"});
    return world;
}

Response post(const World& world, const std::string& path, const json& body) {
    HttpRequest request;
    request.method = "POST";
    request.path = path;
    request.body = body.dump();
    return answer(world, request, {});
}

Response value_of(const std::string& key, const std::string& text) {
    return post(world_with({}), "/api/value", {{"key", key}, {"text", text}});
}

std::string what_of(const Response& response) {
    EXPECT_EQ(response.status, 400) << response.body;
    return json::parse(response.body)["error"]["what"];
}

// the case that a shared design is on a machine that has the paper's cases only
Case opened(const json& design) {
    std::vector<std::string> set = design["set"];
    World world;
    world.presets = paper_presets();
    io::TomlSource source = source_of(preset_named(world, design["preset"].get<std::string>()));
    source.overrides = set;
    return io::read_case(source);
}

TEST(Value, IsReadAsTheCommandLineReadsIt) {
    EXPECT_EQ(json::parse(value_of("contact.preload", "2 kN").body)["value"], 2000.0);
    EXPECT_EQ(json::parse(value_of("drive.amplitude", "0.5 mm").body)["value"], 0.0005);
    EXPECT_EQ(json::parse(value_of("joint.incidence_angle", "70 deg").body)["value"], 70.0);
    EXPECT_EQ(json::parse(value_of("contact.kinetic_friction", "60 %").body)["value"], 0.6);
    EXPECT_EQ(json::parse(value_of("contact.preload", "17").body)["value"], 17.0);
}

TEST(Value, OfAnotherUnitIsRefusedInTheProgramsWordsAndNamesItsField) {
    const Response response = value_of("contact.preload", "5 kg");
    EXPECT_NE(what_of(response).find("contact.preload"), std::string::npos) << response.body;
    EXPECT_NE(response.body.find("mass"), std::string::npos) << response.body;
    EXPECT_EQ(json::parse(response.body)["error"]["key"], "contact.preload");
    for (const std::string& text : {std::string("nonsense"), std::string(""), std::string("1e999 N"),
                                    std::string(1000, '1'), std::string("2 N\n3"), std::string("nan")})
        EXPECT_EQ(value_of("contact.preload", text).status, 400) << text;
}

TEST(Value, IsOfAQuantityOnly) {
    for (const char* key : {"drive.kind", "drive.file", "title", "nothing", ""})
        EXPECT_EQ(value_of(key, "1").status, 400) << key;
}

TEST(Share, OfAPaperCaseHoldsWhatWasChanged) {
    const Response response =
        post(world_with({}), "/api/share", {{"preset", "creak"}, {"set", {"contact.preload=1 kN"}}});
    const json design = json::parse(response.body);
    EXPECT_EQ(design["preset"], "creak");
    EXPECT_EQ(design["set"], json({"contact.preload=1000"}));
}

// whatever a file says, its link says the same case
RC_GTEST_PROP(Share, OfAFileIsTheSameCaseWithoutTheFile, ()) {
    Case c = parameters::paper_case(static_cast<PaperCase>(*rc::gen::inRange(0, 4)));
    for (const Field& field : parameters::fields()) {
        const auto* quantity = std::get_if<parameters::Quantity>(&field.kind);
        const bool is_varied =
            quantity != nullptr && quantity->usual && field.belongs(c) && *rc::gen::arbitrary<bool>();
        if (!is_varied || field.name == "static_friction" || field.name == "kinetic_friction") continue;
        const double part = *rc::gen::inRange(1, 1000000) / 1e6;
        quantity->set(c, quantity->usual->from + part * (quantity->usual->to - quantity->usual->from));
    }
    const Response response = post(world_with(c), "/api/share", {{"preset", "file"}});
    RC_ASSERT(response.status == 200);
    const json design = json::parse(response.body);
    RC_ASSERT(design["preset"] != "file");
    RC_ASSERT(parameters::canonical_text(opened(design)) == parameters::canonical_text(c));
    RC_ASSERT(response.body.size() < 3000);
}

TEST(Share, KeepsAConstantDriveOfAFile) {
    Case c = parameters::paper_case(PaperCase::squeal);
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = -0.07;
    const json design = json::parse(post(world_with(c), "/api/share", {{"preset", "file"}}).body);
    EXPECT_EQ(parameters::canonical_text(opened(design)), parameters::canonical_text(c)) << design;
}

TEST(Share, SaysThatASampledDriveStaysBehind) {
    World world = world_with(parameters::paper_case(PaperCase::squeal));
    std::string& text = world.presets.front().toml;
    const std::size_t from = text.find("[drive]");
    text.replace(from, text.find("\n[", from) - from, "[drive]\nkind = \"sampled\"\nfile = \"shake.csv\"\n");
    world.presets.front().samples_file = "shake.csv";
    world.presets.front().samples = {{0.0, 0.5, 5.0}, {0.1, -0.1, 0.1}};
    const Response response = post(world, "/api/share", {{"preset", "file"}});
    EXPECT_EQ(what_of(response), "a sampled drive does not travel in a link");
}

TEST(Share, OfAPageWhoseFileIsNotHereIsExplained) {
    World world;
    world.presets = paper_presets();
    const Response response = post(world, "/api/simulate", {{"preset", "file"}});
    EXPECT_EQ(what_of(response), "the case of this link is a file that is not here");
}

TEST(Start, HasTheChartOfItsFileWithAsManyPointsAsMayBeExplored) {
    World world = world_with(parameters::paper_case(PaperCase::squeal));
    world.presets.front().study = io::read_study(
        {world.presets.front().toml +
             "\n[chart]\nx = { parameter = \"plate.mass\", from = \"100 g\", to = \"2 kg\", points = 1000, scale = "
             "\"log\" }\n"
             "y = { parameter = \"contact.preload\", from = 5, to = 15, points = 20 }\nquantities = [\"frequency\"]\n",
         "seal.toml",
         {}});
    HttpRequest request;
    request.method = "GET";
    request.path = "/api/start";
    const json document = json::parse(answer(world, request, {}).body);
    const json& chart = document["presets"][0]["chart"];
    EXPECT_EQ(chart["x"],
              json({{"parameter", "plate.mass"}, {"from", 0.1}, {"to", 2.0}, {"points", 256}, {"scale", "log"}}));
    EXPECT_EQ(chart["y"]["to"], 15.0);
    EXPECT_EQ(chart["figure"], "frequency");
    EXPECT_FALSE(document["presets"][1].contains("chart"));
}

TEST(SeveralJoints, AreShownSetAndSimulatedByTheirNames) {
    const World world = world_with(parameters::two_lips());
    const json body{{"preset", "file"},
                    {"set", {"joint.lower.contact.preload=55", "run.duration=0.05", "run.window=0.05"}}};
    const Response simulated = post(world, "/api/simulate", body);
    ASSERT_EQ(simulated.status, 200) << simulated.body;
    const json joints = json::parse(simulated.body)["case"]["joint"];
    ASSERT_EQ(joints.size(), 2U);
    EXPECT_EQ(joints[0]["contact"]["preload"], 200.0);
    EXPECT_EQ(joints[1]["name"], "lower");
    EXPECT_EQ(joints[1]["contact"]["preload"], 55.0);
    EXPECT_EQ(json::parse(value_of("joint.lower.contact.preload", "2 kN").body)["value"], 2000.0);
    EXPECT_EQ(what_of(post(world, "/api/share", {{"preset", "file"}})), "several joints do not travel in a link");
    const Response refused = post(world, "/api/simulate", {{"preset", "file"}, {"set", {"joint.lower.mass=-1"}}});
    EXPECT_NE(what_of(refused).find("mass = -1 is out of range"), std::string::npos);
    const json chart{
        {"x", {{"parameter", "joint.lower.mass"}, {"from", -1.0}, {"to", 1.0}, {"points", 4}, {"scale", "linear"}}},
        {"y", {{"parameter", "plate.mass"}, {"from", 0.1}, {"to", 1.0}, {"points", 4}, {"scale", "linear"}}}};
    const Response axis = post(world, "/api/chart", {{"preset", "file"}, {"chart", chart}});
    EXPECT_EQ(json::parse(axis.body)["error"]["key"], "joint.lower.mass") << axis.body;
}

TEST(SeveralJoints, MoveInColumnsOfTheirOwn) {
    const World world = world_with(parameters::two_lips());
    const Response response =
        post(world, "/api/motion", {{"preset", "file"}, {"set", {"run.duration=0.05", "run.window=0.05"}}});
    ASSERT_EQ(response.status, 200) << response.body;
    const std::string text = response.body.substr(0, 8192);
    for (const char* name : {"\"x1\"", "\"y1\"", "\"x_lower\"", "\"y_lower\"", "\"y2\"", "\"gap_1\"", "\"gap_2\""})
        EXPECT_NE(text.find(name), std::string::npos) << name;
    EXPECT_NE(text.find("displacement of upper along the plate"), std::string::npos);
    EXPECT_NE(text.find("velocity of lower across the plate"), std::string::npos);
    EXPECT_NE(text.find("displacement of the plate across the contact"), std::string::npos);
}

}  // namespace
}  // namespace stridor::explorer
