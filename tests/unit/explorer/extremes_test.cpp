// Whatever number the page sends for a field: an answer, a refusal, or an end within a second of the client leaving.

#include "stridor/base/text.hpp"
#include "stridor/explorer/api.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "support/effort.hpp"
#include "support/patience.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

namespace stridor::explorer {
namespace {

using nlohmann::json;

World paper_world() {
    World world;
    world.presets = paper_presets();
    world.threads = 2;
    return world;
}

// the client leaves after a tenth of a second
void expect_an_end(const std::string& path, const json& body) {
    HttpRequest request;
    request.method = "POST";
    request.path = path;
    request.body = body.dump();
    support::Patience client(0.1);
    Response response = answer(paper_world(), request, client.token());
    std::string streamed;
    if (response.stream) response.stream([&](const std::string& part) { streamed += part; }, client.token());
    EXPECT_FALSE(client.is_worn_out()) << path << " " << request.body;
    constexpr std::array known{200, 400, 422, 503};
    EXPECT_NE(std::find(known.begin(), known.end(), response.status), known.end())
        << path << " " << request.body << "\n"
        << response.body;
    if (!response.content_type.starts_with("application/json")) return;
    EXPECT_FALSE(json::parse(response.body, nullptr, false).is_discarded()) << path << " " << request.body;
}

json design(const std::string& key, double value, const std::string& drive) {
    json set = {"run.duration=0.4", "run.window=0.4", "drive.kind=" + drive};
    if (drive == "constant") set.push_back("drive.velocity=0.1");
    if (key == "contact.restitution") set.push_back("contact.impact=restitution");
    if (key == "contact.kinetic_friction") set.push_back("contact.static_friction=" + base::shortest(value));
    set.push_back(key + "=" + base::shortest(value));
    return {{"preset", "squeal"}, {"set", set}};
}

constexpr std::array far{1e-300, 1e-12, 1e12, 1e300};

TEST(FarRequests, EndOrAreRefused) {
    std::size_t number = 0;
    constexpr std::size_t every = support::effort<std::size_t>(1, 8);
    for (const std::string& key : parameters::quantity_keys())
        for (const double value : far)
            for (const std::string drive : {"sinusoidal", "constant"}) {
                if (++number % every != 0) continue;
                const json body = design(key, value, drive);
                expect_an_end("/api/simulate", body);
                if (number % 4 != 0) continue;
                expect_an_end("/api/motion", body);
                json sound = body;
                sound["seconds"] = 0.5;
                expect_an_end("/api/sound", sound);
            }
}

// the ends of an axis or of a scan are values as well
TEST(FarRequests, EndOverRangesThatSpanAllNumbers) {
    std::size_t number = 0;
    constexpr std::size_t every = support::effort<std::size_t>(1, 8);
    for (const std::string& key : parameters::quantity_keys()) {
        if (++number % every != 0) continue;
        json scan = design("contact.preload", 20.0, "constant");
        scan["over"] = {{"key", key}, {"from", 1e-300}, {"to", 1e300}, {"points", 50}};
        expect_an_end("/api/stability", scan);
        json chart = design("contact.preload", 20.0, "constant");
        const std::string other = key == "joint.mass" ? "plate.mass" : "joint.mass";
        chart["chart"] = {
            {"x", {{"parameter", key}, {"from", 1e-300}, {"to", 1e300}, {"points", 3}, {"scale", "log"}}},
            {"y", {{"parameter", other}, {"from", 1e-12}, {"to", 1e12}, {"points", 3}, {"scale", "log"}}}};
        expect_an_end("/api/chart", chart);
    }
}

// 1 MHz for a minute was made beforehand: 3.5 GiB
TEST(FarRequests, AreRefusedWhereTheyWouldFillTheMemory) {
    for (const std::string frequency : {"1e6", "1e9", "1e74"}) {
        HttpRequest request;
        request.method = "POST";
        request.path = "/api/simulate";
        request.body =
            json{{"preset", "squeal"}, {"set", {"run.duration=60", "run.window=60", "drive.frequency=" + frequency}}}
                .dump();
        const Response response = answer(paper_world(), request, {});
        EXPECT_EQ(response.status, 400);
        EXPECT_NE(response.body.find("drive.frequency"), std::string::npos) << response.body;
    }
}

}  // namespace
}  // namespace stridor::explorer
