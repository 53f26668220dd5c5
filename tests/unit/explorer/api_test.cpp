#include "stridor/explorer/api.hpp"

#include "stridor/explorer/sent_columns.hpp"
#include "stridor/explorer/served_world.hpp"
#include "stridor/noise_library/add_recordings.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/signal/source.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace stridor::explorer {
namespace {

using nlohmann::json;

World world() {
    World world;
    world.presets = paper_presets();
    world.threads = 2;
    return world;
}

Response post(const std::string& path, const std::string& body) {
    HttpRequest request;
    request.method = "POST";
    request.path = path;
    request.body = body;
    return answer(world(), request, {});
}

Response get(const std::string& path) {
    HttpRequest request;
    request.method = "GET";
    request.path = path;
    return answer(world(), request, {});
}

// a short run, so that sanitizers have little to do
json design(std::vector<std::string> set = {}) {
    set.insert(set.end(), {"run.duration=0.3", "run.window=0.3"});
    return {{"preset", "squeal"}, {"set", set}};
}

json chart_request() {
    json body = design({"drive.kind=constant", "drive.velocity=0.1", "run.duration=0.05", "run.window=0.02"});
    body["set"] = {"drive.kind=constant", "drive.velocity=0.1", "run.duration=0.05", "run.window=0.02"};
    body["chart"] = {{"x", {{"parameter", "contact.preload"}, {"from", 1}, {"to", 80}, {"points", 33}}},
                     {"y", {{"parameter", "contact.kinetic_friction"}, {"from", 0}, {"to", 0.8}, {"points", 17}}},
                     {"refine", 2}};
    return body;
}

std::vector<json> lines_of(const Response& response, const std::stop_token& stop = {}) {
    std::vector<json> lines;
    response.stream([&](const std::string& part) { lines.push_back(json::parse(part)); }, stop);
    return lines;
}

std::string refusal(const Response& response, int status) {
    EXPECT_EQ(response.status, status) << response.body;
    const json document = json::parse(response.body);
    EXPECT_EQ(document["schema"], "stridor.explorer.error/1");
    return document["error"]["what"].get<std::string>() + " (" + document["error"]["why"].get<std::string>() + ")";
}

TEST(Api, BeginsWithThePresetsAndTheFieldsTheirSlidersNeed) {
    const json document = json::parse(get("/api/start").body);
    EXPECT_EQ(document["presets"].size(), 4U);
    EXPECT_EQ(document["presets"][0]["name"], "squeal");
    EXPECT_EQ(document["presets"][0]["case"]["contact"]["preload"], 20.0);
    int sliders = 0;
    for (const json& field : document["fields"])
        if (field.contains("usual")) {
            ++sliders;
            EXPECT_LT(field["usual"]["from"], field["usual"]["to"]) << field;
        }
    EXPECT_GE(sliders, 12);
    const auto field = [&](const std::string& key) {
        for (const json& each : document["fields"])
            if (each["key"] == key) return each;
        return json();
    };
    EXPECT_EQ(field("drive.velocity")["belongs_to"], (json{{"drive.kind", {"constant", "trapezoidal"}}}));
    EXPECT_EQ(field("drive.velocity")["default"], 0.1);
    EXPECT_EQ(field("joint.mass")["belongs_to"], json::object());
    EXPECT_FALSE(field("run.step").contains("default"));  // a case may leave it out
    EXPECT_FALSE(document["figures"].empty());
}

// what a slider of the page goes over: it must hold the value that it begins with
TEST(Api, VariesQuantitiesAroundTheOnesOfTheCase) {
    World soft = world();
    soft.presets.push_back(preset_of({soft.presets.front().toml,
                                      "soft.toml",
                                      {"joint.mass=4 g", "joint.flexural_stiffness=1.5 kN/m", "contact.preload=0.67 N",
                                       "drive.kind=constant", "drive.velocity=-50 mm/s"}}));
    HttpRequest request;
    request.method = "GET";
    request.path = "/api/start";
    const json document = json::parse(answer(soft, request, {}).body);
    const json& ranges = document["presets"].back()["ranges"];
    EXPECT_DOUBLE_EQ(ranges["joint.mass"]["from"], 4e-4);
    EXPECT_DOUBLE_EQ(ranges["joint.mass"]["to"], 4e-2);
    EXPECT_DOUBLE_EQ(ranges["joint.flexural_stiffness"]["from"], 150.0);
    EXPECT_EQ(ranges["joint.flexural_stiffness"]["scale"], "log");
    EXPECT_DOUBLE_EQ(ranges["drive.velocity"]["from"], 5e-3) << "its magnitude";
    EXPECT_EQ(ranges["contact.kinetic_friction"]["scale"], "linear");
    EXPECT_FALSE(ranges.contains("run.duration"));
    for (const json& preset : document["presets"])
        for (const auto& [key, range] : preset["ranges"].items()) {
            const std::size_t dot = key.find('.');
            const double value = std::abs(preset["case"][key.substr(0, dot)][key.substr(dot + 1)].get<double>());
            EXPECT_LE(range["from"], value) << key;
            EXPECT_GE(range["to"], value) << key;
        }
}

TEST(Api, SimulatesADesign) {
    const json document = json::parse(post("/api/simulate", design({"contact.preload=25"}).dump()).body);
    EXPECT_EQ(document["schema"], "stridor.simulation/1");
    EXPECT_EQ(document["case"]["contact"]["preload"], 25.0);
    EXPECT_EQ(document["phases"].size(), 2U);
}

TEST(Api, TellsAllThatIsWrongAndSaysHowMuchItLeavesOut) {
    const auto error_of = [](std::vector<std::string> set) {
        const Response response = post("/api/simulate", design(std::move(set)).dump());
        EXPECT_EQ(response.status, 400);
        return json(json::parse(response.body)["error"]);
    };
    const json two = error_of({"contact.preload=-1", "joint.mass=2 m"});
    EXPECT_EQ(two["key"], "contact.preload");
    ASSERT_EQ(two["others"].size(), 1U) << two;
    EXPECT_EQ(two["others"][0]["key"], "joint.mass");
    EXPECT_EQ(two["untold"], 0);
    std::vector<std::string> many;
    for (int i = 0; i < 50; ++i)
        many.push_back("joint.nothing" + std::to_string(i) + "=1");
    const json some = error_of(many);
    EXPECT_EQ(1 + some["others"].size() + some["untold"].get<std::size_t>(), 50U) << some;
    EXPECT_LT(some["others"].size(), 20U);
    EXPECT_EQ(error_of({"contact.preload=-1"})["others"].size(), 0U);
}

TEST(Api, SendsAMotionAsArrays) {
    json body = design();
    body["interval"] = 1e-4;
    const std::string bytes = post("/api/motion", body.dump()).body;
    std::uint32_t length = 0;
    ASSERT_GT(bytes.size(), 4U);
    std::memcpy(&length, bytes.data(), 4);
    ASSERT_EQ((length + 4) % 8, 0U);
    const json header = json::parse(bytes.substr(4, length));
    const auto samples = header["samples"].get<std::size_t>();
    EXPECT_NEAR(static_cast<double>(samples), 3000.0, 2.0);
    const std::size_t column = (4 * samples + 7) / 8 * 8;
    ASSERT_EQ(header["contacts"].size(), 1U);
    EXPECT_EQ(header["contacts"][0]["name"], "joint");
    const auto intervals = header["contacts"][0]["intervals"].get<std::size_t>();
    const std::size_t history = (8 * (intervals + 1) + intervals + 7) / 8 * 8;
    EXPECT_EQ(bytes.size(), 4 + length + header["columns"].size() * column + history);
    // the imposed velocity begins at its peak, 2 pi f A
    std::size_t number = 0;
    while (header["columns"][number]["name"] != "surface_velocity")
        ++number;
    float velocity = 0.0F;
    std::memcpy(&velocity, bytes.data() + 4 + length + number * column, 4);
    EXPECT_NEAR(velocity, 2.0 * 3.14159265 * 5.0 * 4e-3, 1e-6);
}

TEST(Api, ShowsAChartWhileItIsRefined) {
    const json body = chart_request();
    const std::vector<json> frames = lines_of(post("/api/chart", body.dump()));
    ASSERT_GE(frames.size(), 2U);
    EXPECT_EQ(frames.front()["x"]["values"].size(), 33U);
    EXPECT_EQ(frames.front()["directions"].size(), 2U);
    for (std::size_t k = 0; k < frames.size(); ++k) {
        EXPECT_EQ(frames[k]["round"], k);
        EXPECT_EQ(frames[k]["done"], k + 1 == frames.size());
        EXPECT_TRUE(k == 0 || frames[k]["computed"] > frames[k - 1]["computed"]) << k;
        EXPECT_EQ(frames[k]["category"].get<std::string>().size(), (2 * 33 * 17 + 2) / 3 * 4);
    }
    EXPECT_EQ(frames.back()["gaps"], "");
}

// the four corners of so small a chart may agree while all between them differs
TEST(Api, ComputesAllOfASmallChart) {
    json body = chart_request();
    body["chart"]["refine"] = 3;
    for (const bool is_preview : {false, true}) {
        body["preview"] = is_preview;
        for (const char* axis : {"x", "y"})
            body["chart"][axis]["points"] = 8;
        const json small = lines_of(post("/api/chart", body.dump())).back();
        EXPECT_EQ(small["computed"], small["total"]);
        for (const char* axis : {"x", "y"})
            body["chart"][axis]["points"] = 64;
        const json usual = lines_of(post("/api/chart", body.dump())).back();
        EXPECT_LT(usual["computed"], 0.5 * usual["total"].get<double>());
    }
}

TEST(Api, StopsAChartWhenAsked) {
    json body = chart_request();
    body["chart"]["x"]["points"] = 256;
    body["chart"]["y"]["points"] = 256;
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(lines_of(post("/api/chart", body.dump()), stop.get_token()).empty());
}

TEST(Api, FollowsStability) {
    json body = design();
    body["over"] = {{"key", "contact.kinetic_friction"}, {"from", 0}, {"to", 0.8}};
    const json document = json::parse(post("/api/stability", body.dump()).body);
    EXPECT_EQ(document["schema"], "stridor.stability/1");
}

TEST(Api, WritesTheCaseAsAFile) {
    const Response response = post("/api/toml", design({"contact.preload=25"}).dump());
    EXPECT_NE(response.body.find("preload = \"25 N\""), std::string::npos);
}

TEST(Api, MakesASoundOfADirection) {
    json body = design();
    body["direction"] = "going";
    body["rate"] = 44100;
    const Response response = post("/api/sound", body.dump());
    EXPECT_EQ(response.content_type, "audio/wav");
    EXPECT_EQ(response.body.substr(0, 4), "RIFF");
    std::uint32_t size = 0;
    std::memcpy(&size, response.body.data() + 4, 4);
    EXPECT_EQ(size + 8, response.body.size());
    // of its periods of 0.2 s the drive goes for the first and the last quarter
    EXPECT_NEAR(static_cast<double>(response.body.size()), 2 * 44100 * 0.15, 1500.0);
    const json heard = json::parse(post("/api/analysis", body.dump()).body);
    EXPECT_EQ(heard["unit"], "m/s");
    EXPECT_EQ(heard["verdict"]["category"], "squeal");
    EXPECT_FALSE(heard["spectrogram"]["level"].get<std::string>().empty());
    // a motion is judged by the rules, which follow no tracks
    EXPECT_TRUE(heard["impulses"].is_null());
    EXPECT_TRUE(heard["verdict"]["probability"].is_null());
    EXPECT_TRUE(heard["tracks"]["onsets"].empty());
    EXPECT_TRUE(heard["tracks"]["pitch"]["time"].empty());
}

// half a second of a steady tone
signal::Signal tone() {
    signal::Signal signal{48000.0, "Pa", {}};
    for (int k = 0; k < 24000; ++k)
        signal.samples.push_back(0.1 * std::sin(2.0 * 3.14159265358979 * 800.0 * k / signal.rate));
    return signal;
}

TEST(Api, ShowsPlaysAndHearsTheLibrary) {
    const support::ScratchFolder folder;
    const std::string file = (folder / "tone.wav").string();
    recordings::write_wav(file, *signal::source_of({tone()}));
    World with_library = world();
    with_library.library = folder / "noises.sqlite";
    {
        noise_library::Library library(with_library.library, {noise_library::Access::fill});
        noise_library::Recording recording{file, {}};
        recording.given.system = "brake";
        noise_library::add_recording(library, recording, [](const std::filesystem::path&, noise_library::Entry&) {});
    }
    const auto ask = [&](const std::string& path) {
        HttpRequest request;
        request.method = "GET";
        request.path = path;
        return answer(with_library, request, {});
    };
    const json list = json::parse(ask("/api/library").body);
    ASSERT_EQ(list["entries"].size(), 1U);
    EXPECT_EQ(list["entries"][0]["system"], "brake");
    const std::string entry = "/api/library/" + list["entries"][0]["id"].dump();
    const Response audio = ask(entry + "/audio");
    EXPECT_EQ(audio.content_type, "audio/wav");
    std::string bytes;
    audio.stream([&](const std::string& part) { bytes += part; }, {});
    std::ifstream stream(file, std::ios::binary);
    EXPECT_EQ(bytes, std::string(std::istreambuf_iterator<char>(stream), {}));
    const json heard = json::parse(ask(entry + "/analysis").body);
    EXPECT_EQ(heard["unit"], "Pa");
    EXPECT_EQ(heard["verdict"]["category"], "squeal");
    EXPECT_GT(heard["verdict"]["probability"], 0.5);
    EXPECT_LE(heard["verdict"]["probability"], 1.0);
    const json& pitch = heard["tracks"]["pitch"];
    ASSERT_FALSE(pitch["time"].empty());
    ASSERT_EQ(pitch["time"].size(), pitch["frequency"].size());
    for (const json& frequency : pitch["frequency"])
        EXPECT_NEAR(frequency.get<double>(), 800.0, 10.0);
    EXPECT_EQ(heard["impulses"]["rows"], heard["impulses"]["time"].size());
    EXPECT_LE(heard["impulses"]["frequency"].back(), 12e3 + 200.0);
    refusal(ask("/api/library/99/audio"), 400);
    // a library from elsewhere may hold anything under that name
    std::filesystem::path sound;
    for (const auto& each : std::filesystem::recursive_directory_iterator(folder.path()))
        if (each.path().extension() == ".wav" && each.path() != file) sound = each.path();
    std::filesystem::remove(sound);
    ASSERT_EQ(::mkfifo(sound.c_str(), 0600), 0);
    EXPECT_NE(refusal(ask(entry + "/audio"), 500).find("damaged"), std::string::npos);
    EXPECT_NE(refusal(ask(entry + "/analysis"), 500).find("damaged"), std::string::npos);
}

TEST(Api, JudgesTheSoundOfAMicrophone) {
    const std::string wav = recordings::wav_bytes(tone(), {1.0, "Pa"});
    const Response response = post("/api/recording", wav);
    ASSERT_EQ(response.status, 200) << response.body;
    const json heard = json::parse(response.body);
    EXPECT_EQ(heard["verdict"]["category"], "squeal");
    EXPECT_GT(heard["verdict"]["probability"], 0.5);
    EXPECT_EQ(heard["spectrogram"]["rows"], heard["spectrogram"]["time"].size());
    for (const std::string& other : {std::string(), std::string("{\"preset\": \"squeal\"}"), "OggS" + wav.substr(4)})
        EXPECT_NE(refusal(post("/api/recording", other), 400).find("no WAV file"), std::string::npos) << other.size();
    refusal(post("/api/recording", wav.substr(0, 200)), 400);
}

TEST(Api, PrintsACommandThatAShellTakesForOne) {
    json body = design({"drive.kind=constant", "drive.velocity=0.1 m/s", "title=it's; touch /tmp/x"});
    body["samples"] = 8;
    const Response response = post("/api/report", body.dump());
    ASSERT_EQ(response.status, 200) << response.body;
    EXPECT_NE(response.body.find(
                  "stridor init squeal | stridor simulate - --set drive.kind=constant --set 'drive.velocity=0.1 "
                  "m/s' --set 'title=it'\\''s; touch /tmp/x'"),
              std::string::npos);
    body["preset"] = "squeal; touch /tmp/x";
    EXPECT_NE(refusal(post("/api/report", body.dump()), 400).find("no preset"), std::string::npos);
}

TEST(Api, SaysWhatIsWrongWithARequest) {
    EXPECT_NE(refusal(post("/api/simulate", design({"contact.preload=-1"}).dump()), 400).find("out of range"),
              std::string::npos);
    EXPECT_NE(refusal(post("/api/simulate", R"({"preset":"none"})"), 400).find("no preset"), std::string::npos);
    EXPECT_NE(
        refusal(post("/api/simulate", R"({"preset":"squeal","set":["run.duration=1000"]})"), 400).find("too long"),
        std::string::npos);
    json body = chart_request();
    body["chart"]["x"]["points"] = 100000;
    EXPECT_NE(refusal(post("/api/chart", body.dump()), 400).find("too many"), std::string::npos);
    refusal(get("/api/library"), 400);
    refusal(get("/api/nothing"), 404);
    refusal(post("/api/start", "{}"), 404);
}

TEST(Api, NeverOpensAFileThatARequestNames) {
    for (const char* text : {"drive.file=/etc/passwd", "drive . file=/etc/passwd", "\"drive\".file=x", "drive.'file'=x",
                             "drive={kind='sampled',file='/etc/passwd'}"})
        EXPECT_NE(refusal(post("/api/simulate", json{{"preset", "squeal"}, {"set", {text}}}.dump()), 400), "") << text;
    // whatever the spelling, the answer never tells whether the file is there
    for (const char* path :
         {"/../../etc/passwd", "/%2e%2e/etc/passwd", "//etc/passwd", "/page.js/../../x", "/api/library/../x"})
        refusal(get(path), 404);
}

TEST(Api, AnswersEveryMalformedBodyWithAnError) {
    const std::vector<std::string> bodies{"",
                                          "null",
                                          "[]",
                                          "1",
                                          "\"x\"",
                                          "{",
                                          "{\"preset\":}",
                                          "{\"preset\":1}",
                                          R"({"preset":"squeal","set":{}})",
                                          R"({"preset":"squeal","set":[1]})",
                                          R"({"preset":"squeal","set":["x"]})",
                                          R"({"preset":"squeal","set":["=1"]})",
                                          R"({"preset":"squeal","set":["contact.preload=nan"]})",
                                          "{\"preset\":\"\\ud800\"}",
                                          "\xff\xfe{}",
                                          std::string(100000, '['),
                                          std::string(1000, '\0')};
    for (const char* path : {"/api/simulate", "/api/motion", "/api/chart", "/api/stability", "/api/toml", "/api/sound",
                             "/api/analysis", "/api/advice", "/api/report", "/api/value", "/api/share"})
        for (const std::string& body : bodies)
            refusal(post(path, body), 400);
}

// a valid request with bytes changed is answered, one way or the other, and never ends the program
RC_GTEST_PROP(Api, SurvivesEveryChangeOfABody, ()) {
    std::string body = chart_request().dump();
    const auto changes = *rc::gen::inRange(1, 6);
    for (int k = 0; k < changes; ++k) {
        const auto at = static_cast<std::size_t>(*rc::gen::inRange<int>(0, static_cast<int>(body.size())));
        body[at] = static_cast<char>(*rc::gen::inRange(1, 256));
    }
    for (const char* path : {"/api/toml", "/api/stability", "/api/chart", "/api/share"}) {
        const Response response = post(path, body);
        RC_ASSERT(response.status == 200 || response.status == 400);
    }
}

}  // namespace
}  // namespace stridor::explorer
