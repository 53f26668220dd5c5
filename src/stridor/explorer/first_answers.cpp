#include "stridor/explorer/first_answers.hpp"

#include "stridor/base/json.hpp"
#include "stridor/base/version.hpp"
#include "stridor/explorer/answers/answers.hpp"
#include "stridor/explorer/answers/seam.hpp"
#include "stridor/explorer/body.hpp"
#include "stridor/explorer/world.hpp"
#include "stridor/integration/cost.hpp"
#include "stridor/sweep/study.hpp"

#include <boost/beast/zlib/deflate_stream.hpp>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace stridor::explorer {

namespace {

constexpr int done = 200;
constexpr int without_content = 204;
constexpr double longest_chart = 10.0;  // [s] of one core, if each cell is run

// as RFC 1951 has it
std::string deflated(const std::string& text) {
    namespace zlib = boost::beast::zlib;
    zlib::deflate_stream stream;
    stream.reset(9, 15, 9, zlib::Strategy::normal);
    std::string packed(stream.upper_bound(text.size()), '\0');
    zlib::z_params ends;
    ends.next_in = text.data();
    ends.avail_in = text.size();
    ends.next_out = packed.data();
    ends.avail_out = packed.size();
    boost::beast::error_code error;
    stream.write(ends, zlib::Flush::finish, error);
    packed.resize(ends.total_out);
    return packed;
}

// bytes as letters of windows-1252, which the page is written in (explorer/build_page.mjs)
std::string letters_of(const std::string& bytes) {
    constexpr char escape = '=';
    constexpr int shift = 64;
    std::string letters;
    for (const char byte : bytes) {
        const bool is_changed = byte == '\0' || byte == '\r' || byte == '<' || byte == escape;
        if (is_changed) letters += escape;
        letters += is_changed ? static_cast<char>(byte + shift) : byte;
    }
    return letters;
}

// a question, and its answer
struct Told {
    std::string path;
    Json body;
    std::string answer;
};

// Adds a question with its answer; returns whether it has a result.
bool add(std::vector<Told>& all, std::string path, Json body, const std::function<Response()>& ask) {
    Response response = answered(ask);
    if (response.status != done) return false;
    all.push_back({std::move(path), std::move(body), std::move(response.body)});
    return true;
}

bool takes_long(const sweep::Study& study) {
    return integration::cost(study.base).seconds * static_cast<double>(sweep::cell_count(study)) > longest_chart;
}

// the chart that the page begins with, as one frame; without content if it takes long or has no end
Response first_chart(const World& world, const Json& body) {
    if (takes_long(study_in(world, body))) return plain(without_content, "");
    std::vector<std::string> lines;
    const Response response = chart(world, body, {});
    response.stream([&](std::string line) { lines.push_back(std::move(line)); }, {});
    const Json first = Json::parse(lines.front());
    Json last = Json::parse(lines.back());
    if (!last.value("done", false)) return plain(without_content, "");
    // how often the chart was looked at on its way is the machine's
    last["round"] = 0;
    for (const char* name : {"x", "y", "directions"})
        last[name] = first.at(name);
    return json(last.dump());
}

// the chart that the page asks for where nobody chose another one (explorer/src/main.ts)
Json chart_body(Json body, const Preset& preset) {
    Json axes = default_chart();
    std::string figure = "category";
    if (preset.study) {
        const Json own = chart_of(*preset.study);
        axes["x"] = own.at("x");
        axes["y"] = own.at("y");
        figure = own.at("figure");
    }
    body["chart"] = std::move(axes);
    body["preview"] = false;
    body["figure"] = figure;
    return body;
}

// what the page asks when it is opened with this case
std::vector<Told> first_answers(const StandingCase* standing) {
    World world{paper_presets(), {}};
    std::vector<Told> all;
    std::string name = "squeal";
    const bool has_begun = add(all, "/api/start", "", [&] {
        if (standing != nullptr) {
            world.presets.insert(world.presets.begin(), preset_of({standing->toml, "case.toml", {}}, {}));
            name = world.presets.front().name;
        }
        return start(world);
    });
    if (!has_begun) return {};
    const Json body{{"preset", name}, {"set", Json::array()}};
    if (!add(all, "/api/simulate", body, [&] { return simulate(world, body, {}); })) return {};
    Json stands = body;
    stands["around"] = false;
    add(all, "/api/design", stands, [&] { return design(world, stands, {}); });
    const Json charted = chart_body(body, preset_named(world, name));
    add(all, "/api/chart", charted, [&] { return first_chart(world, charted); });
    return all;
}

}  // namespace

std::string page_with_first_answers(std::string page, const StandingCase* standing) {
    const std::string place =
        "<script type=\"text/plain\" id=\"stridor-first\" data-commit=\"" + std::string(base::commit()) + "\">";
    const std::size_t at = page.find(place);
    if (at == page.npos || (standing != nullptr && !standing->files.empty())) return page;
    Json answers = Json::array();
    for (const Told& told : first_answers(standing))
        answers.push_back({{"path", told.path}, {"body", told.body}, {"answer", told.answer}});
    if (!answers.empty()) page.insert(at + place.size(), letters_of(deflated(answers.dump())));
    return page;
}

}  // namespace stridor::explorer
