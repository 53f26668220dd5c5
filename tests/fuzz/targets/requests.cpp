#include "fuzz/targets/targets.hpp"
#include "stridor/base/error.hpp"
#include "stridor/explorer/body.hpp"
#include "stridor/explorer/gate.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <array>
#include <string>
#include <utility>

namespace stridor::fuzz {

namespace {

using explorer::HttpRequest;
using explorer::Json;
using explorer::Response;

constexpr std::string_view host = "127.0.0.1:8000";
constexpr std::string_view cookie = "stridor-8000=";

// a gate whose secrets are known
struct Door {
    Door() { renew(); }

    void renew() {
        HttpRequest request;
        request.method = "GET";
        request.path = "/open";
        request.query = "token=" + token;
        request.host = host;
        const std::optional<Response> opened = gate.stop(request);
        require(opened && opened->headers.size() == 2 && opened->headers.back().second.starts_with(cookie));
        session = opened->headers.back().second.substr(cookie.size(), 64);
    }

    std::string token;
    explorer::Gate gate{{"localhost", "127.0.0.1"}, "8000", [this](const std::string& next) { token = next; }};
    std::string session;
};

// nobody guesses a secret: %S stands for the session, %T for the token of the link
std::string with_secrets(std::string text, const Door& door) {
    for (const auto& [sign, secret] : {std::pair("%S", &door.session), std::pair("%T", &door.token)})
        for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at + secret->size()))
            text.replace(at, 2, *secret);
    return text;
}

// method, path, query, Host, Origin, Sec-Fetch-Site, Cookie, Content-Type, a line each; the rest is the body
HttpRequest request_in(std::string_view bytes, const Door& door) {
    HttpRequest request;
    for (std::string* part : {&request.method, &request.path, &request.query, &request.host, &request.origin,
                              &request.fetch_site, &request.cookie, &request.content_type}) {
        const std::size_t end = std::min(bytes.find('\n'), bytes.size());
        *part = with_secrets(std::string(bytes.substr(0, end)), door);
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
    }
    request.body = std::string(bytes);
    return request;
}

void knock(Door& door, const HttpRequest& request) {
    const std::string token = door.token;
    const std::optional<Response> stopped = door.gate.stop(request);
    if (stopped) {
        require(stopped->status >= 200 && stopped->status < 500);
        const bool is_opened = stopped->headers.size() == 2;
        require(is_opened == (door.token != token) && (!is_opened || request.query.find(token) != std::string::npos));
        return;
    }
    // whoever is let in has the session, asks for us by our name, and comes from our page
    require(request.cookie.find(std::string(cookie) + door.session) != std::string::npos);
    require(request.host.starts_with("localhost") || request.host.starts_with("127.0.0.1"));
    require(request.method == "GET" || request.origin == "http://" + request.host);
}

const explorer::World& world() {
    static const explorer::World world = [] {
        explorer::World one;
        const std::string text =
            io::case_toml(parameters::paper_case(parameters::PaperCase::squeal), {io::Comments::none, ""});
        one.presets = {{"squeal", text}, {"file", text, "/nowhere/case.toml", {"contact.preload=25"}}};
        return one;
    }();
    return world;
}

// up to the case or the chart that a body asks for; what is computed from them is no matter of who asked
void read_body(const std::string& text) {
    try {
        const Json body = explorer::parse_body(text);
        const parameters::Case c = explorer::case_in(world(), body);
        require(c.run.duration <= explorer::longest_run && c.drive.file.empty() && c.drive.times.empty());
        if (!body.contains("chart")) return;
        const sweep::Study study = explorer::study_in(world(), body);
        require(study.x.points <= explorer::most_chart_points && study.y.points <= explorer::most_chart_points);
        require(study.base.drive.file.empty() && !io::study_toml(study).empty());
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::input && !error.problem().what.empty());
    }
}

}  // namespace

void requests(std::string_view bytes) {
    static Door door;
    const HttpRequest request = request_in(bytes, door);
    knock(door, request);
    read_body(request.body);
}

}  // namespace stridor::fuzz
