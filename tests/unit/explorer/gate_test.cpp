#include "stridor/explorer/gate.hpp"

#include "server_support.hpp"
#include "stridor/explorer/browser.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace stridor::explorer {
namespace {

const std::vector<std::string> own_hosts{"localhost", "127.0.0.1", "[::1]"};

TEST(FramingSiteTest, TakesAnOriginAsBrowsersWriteIt) {
    EXPECT_EQ(read_framing_site("http://localhost:8888", own_hosts).host, "localhost");
    EXPECT_EQ(read_framing_site("http://127.0.0.1", own_hosts).origin, "http://127.0.0.1");
    EXPECT_EQ(read_framing_site("https://localhost:65535", own_hosts).origin, "https://localhost:65535");
    EXPECT_EQ(read_framing_site("http://hub.example:1", {"hub.example"}).host, "hub.example");
}

// whatever could widen the policy, end its field or begin another one
TEST(FramingSiteTest, RefusesWhatIsNoOrigin) {
    for (const char* text : {"",
                             "*",
                             "http://*",
                             "http://*:8888",
                             "http://*.localhost",
                             "localhost:8888",
                             "http:localhost",
                             "http:///",
                             "http://",
                             "http://localhost:8888/",
                             "http://localhost:8888/tree",
                             "http://localhost:",
                             "http://localhost:*",
                             "http://localhost:0",
                             "http://localhost:08888",
                             "http://localhost:65536",
                             "http://localhost:99999999999",
                             "http://localhost:-1",
                             "http://localhost:+1",
                             "http://localhost:8888 *",
                             "http://localhost:8888;",
                             "http://localhost; script-src *",
                             "http://localhost,http://evil.example",
                             "http://localhost\r\nX-A: b",
                             "http://me@localhost:8888",
                             "http://LOCALHOST:8888",
                             "HTTP://localhost",
                             "http://.localhost",
                             "http://localhost.",
                             "http://-localhost",
                             "http://[::1]:8888",
                             "https://http://localhost",
                             "ftp://localhost",
                             "data:",
                             "null",
                             "'self'",
                             "file:///",
                             "http://localhost?x",
                             "http://localhost#x"}) {
        EXPECT_THROW(read_framing_site(text, own_hosts), Error) << text;
    }
    EXPECT_THROW(read_framing_site("http://" + std::string(254, 'a'), {std::string(254, 'a')}), Error);
    EXPECT_THROW(read_framing_site(std::string("http://localhost\0", 17), own_hosts), Error);
}

TEST(FramingSiteTest, RefusesAnotherHostWhoseFrameWouldHaveNoSession) {
    const support::Thrown thrown = support::thrown_by([] { read_framing_site("http://evil.example:8888", own_hosts); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("evil.example") && thrown.says("--host-name")) << thrown.message;
}

TEST(FramingSiteTest, ChangesOneWordOfTheHeadersAndNothingElse) {
    const std::string none = "frame-ancestors 'none'";
    auto open = security_headers("http://localhost:8888");
    const auto closed = security_headers();
    std::string& policy = open.front().second;
    EXPECT_TRUE(policy.ends_with("; frame-ancestors http://localhost:8888")) << policy;
    policy.replace(policy.rfind("frame-ancestors"), std::string::npos, none);
    EXPECT_EQ(open, closed);
}

TEST(FramingSiteTest, IsInEveryAnswerOfAServerThatHasOne) {
    Server server({}, small_limits(), "http://localhost:8888");
    std::stop_source stop;
    std::thread thread([&] {
        server.serve([](const HttpRequest&, const std::stop_token&) { return plain(200, "page"); }, stop.get_token(),
                     [](const HttpRequest& request) {
                         return request.path == "/" ? std::nullopt : std::optional(plain(403, "no"));
                     });
    });
    for (const std::string& request : {std::string("GET / HTTP/1.1"), std::string("GET /no HTTP/1.1")}) {
        Client client(server.port());
        client.send(request + "\r\nHost: a\r\nConnection: close\r\n\r\n");
        EXPECT_NE(client.receive().find("; frame-ancestors http://localhost:8888\r\n"), std::string::npos) << request;
    }
    stop.request_stop();
    thread.join();
}

class GateTest : public testing::Test {
protected:
    std::vector<std::string> tokens_;  // before what fills it
    Gate gate_{
        {"localhost", "127.0.0.1", "[::1]"}, "8000", [this](const std::string& token) { tokens_.push_back(token); }};

    HttpRequest get(const std::string& path) {
        HttpRequest request;
        request.method = "GET";
        request.path = path;
        request.host = "127.0.0.1:8000";
        return request;
    }

    HttpRequest open(const std::string& token) {
        HttpRequest request = get("/open");
        request.query = "token=" + token;
        return request;
    }

    // what a browser sends back of the cookie
    std::string session() {
        const std::optional<Response> response = gate_.stop(open(tokens_.back()));
        const std::string cookie = response->headers.at(1).second;
        return cookie.substr(0, cookie.find(';'));
    }

    HttpRequest post(const std::string& cookie) {
        HttpRequest request = get("/api/simulate");
        request.method = "POST";
        request.cookie = cookie;
        request.origin = "http://127.0.0.1:8000";
        request.content_type = "application/json";
        return request;
    }

    int status(const HttpRequest& request) {
        const std::optional<Response> response = gate_.stop(request);
        return response ? response->status : 0;
    }
};

TEST_F(GateTest, LetsItsOwnPageThrough) {
    HttpRequest request = post("theme=dark; " + session());
    EXPECT_EQ(status(request), 0);
    request.fetch_site = "same-origin";
    request.content_type = "application/json; charset=utf-8";
    EXPECT_EQ(status(request), 0);
    HttpRequest page = get("/");
    page.cookie = request.cookie;
    page.fetch_site = "none";
    EXPECT_EQ(status(page), 0);
}

// which the program hears from its page alone, as all that is posted
TEST_F(GateTest, LetsTheSoundOfItsOwnPageThrough) {
    HttpRequest request = post(session());
    request.path = "/api/recording";
    EXPECT_EQ(status(request), 415);
    request.content_type = "audio/wav";
    EXPECT_EQ(status(request), 0);
    request.origin = "http://elsewhere.example";
    EXPECT_EQ(status(request), 403);
    request.origin.clear();
    EXPECT_EQ(status(request), 403);
    request.cookie.clear();
    EXPECT_EQ(status(request), 401);
}

TEST_F(GateTest, OpensOnceForEachTokenAndSetsACookieThatScriptsDoNotSee) {
    const std::string token = tokens_.back();
    EXPECT_EQ(token.size(), 64U);
    const std::optional<Response> first = gate_.stop(open(token));
    ASSERT_TRUE(first);
    EXPECT_EQ(first->status, 303);
    EXPECT_EQ(first->headers.at(0), (std::pair<std::string, std::string>{"Location", "/"}));
    EXPECT_NE(first->headers.at(1).second.find("; HttpOnly; SameSite=Strict"), std::string::npos);
    EXPECT_EQ(first->headers.at(1).second.find(token), std::string::npos);
    EXPECT_EQ(status(open(token)), 403);
    ASSERT_EQ(tokens_.size(), 2U);
    EXPECT_NE(tokens_[0], tokens_[1]);
    EXPECT_EQ(status(open(tokens_[1])), 303);
}

TEST_F(GateTest, RefusesTokensThatAreMissingWrongOrCut) {
    for (const std::string& token : {std::string(), std::string("x"), std::string(64, '0'), tokens_.back().substr(1)})
        EXPECT_EQ(status(open(token)), 403) << token;
    EXPECT_EQ(status(get("/open")), 403);
    EXPECT_EQ(tokens_.size(), 1U);
}

TEST_F(GateTest, RefusesForeignHostsEvenWithTheSession) {
    HttpRequest request = post(session());
    for (const char* host : {"", "evil.example", "evil.example:8000", "127.0.0.1.evil.example:8000", "localhost.:8000",
                             "127.0.0.1:8000@evil.example", "127.0.0.1:", "127.0.0.1:80:80", "127.0.0.1 :8000", "[::1",
                             "0", "2130706433:8000", "127.1:8000"}) {
        request.host = host;
        request.origin = "http://" + request.host;
        EXPECT_EQ(status(request), 421) << host;
    }
}

TEST_F(GateTest, RefusesForeignOriginsAndRequestsWithoutOne) {
    HttpRequest request = post(session());
    for (const char* origin : {"", "null", "http://evil.example", "https://127.0.0.1:8000", "http://127.0.0.1:3000",
                               "http://localhost:8000", "http://127.0.0.1:8000.evil.example"}) {
        request.origin = origin;
        EXPECT_EQ(status(request), 403) << origin;
    }
    request = post(request.cookie);
    for (const char* site : {"cross-site", "same-site"}) {
        request.fetch_site = site;
        EXPECT_EQ(status(request), 403) << site;
    }
}

TEST_F(GateTest, RefusesRequestsWithoutASession) {
    for (const std::string& cookie :
         {std::string(), std::string("stridor-8000="), "stridor-8000=" + std::string(64, 'a'), "x" + session(),
          "stridor-8000=" + tokens_.back()})
        EXPECT_EQ(status(post(cookie)), 401) << cookie;
}

TEST_F(GateTest, FindsItsSessionAmongTheCookiesOfOthers) {
    const std::string own = session();
    std::string many;
    for (int k = 0; k < 5000; ++k)
        many += "stridor-8000=" + std::to_string(k) + "; ";
    for (const std::string& cookies :
         {"stridor-8000=; " + own, "stridor-8000=" + std::string(64, '0') + "; " + own, own + "; stridor-8000=x",
          "stridor-80=x; stridor-80000=y; " + own, ";;=;  stridor-8000; " + own + ";", many + own})
        EXPECT_EQ(status(post(cookies)), 0) << cookies.substr(0, 200);
    EXPECT_EQ(status(post(many)), 401);
}

// a browser that came from a file withholds the cookie from what it is redirected to
TEST_F(GateTest, OpensFromAFileByAPageThatGoesOn) {
    HttpRequest request = open(tokens_.back());
    request.fetch_site = "cross-site";
    const std::optional<Response> response = gate_.stop(request);
    ASSERT_TRUE(response);
    EXPECT_EQ(response->status, 200);
    EXPECT_EQ(response->headers.at(0), (std::pair<std::string, std::string>{"Refresh", "0; url=/"}));
    EXPECT_NE(response->headers.at(1).second.find("; HttpOnly; SameSite=Strict"), std::string::npos);
}

TEST_F(GateTest, RefusesOtherMethodsAndTypes) {
    HttpRequest request = post(session());
    request.content_type = "text/plain";
    EXPECT_EQ(status(request), 415);
    request.content_type = "";
    EXPECT_EQ(status(request), 415);
    request.content_type = "audio/wav";
    EXPECT_EQ(status(request), 415);
    for (const char* method : {"PUT", "OPTIONS", "HEAD", "DELETE", "TRACE", "get", ""}) {
        request.method = method;
        EXPECT_EQ(status(request), 405) << method;
    }
}

TEST(Redirect, IsForItsOwnerAloneAndGoesAgain) {
    std::filesystem::path file;
    {
        const Redirect redirect("http://127.0.0.1:8000/open?token=\"<&>");
        file = redirect.file();
        struct stat status {};
        ASSERT_EQ(::stat(file.c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777U, 0600U);
        ASSERT_EQ(::stat(file.parent_path().c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777U, 0700U);
        std::ifstream stream(file);
        const std::string text(std::istreambuf_iterator<char>(stream), {});
        EXPECT_NE(text.find("content=\"0; url=http://127.0.0.1:8000/open?token=&quot;&lt;&amp;>\""), std::string::npos);
        EXPECT_EQ(file.string().find("token"), std::string::npos);
    }
    EXPECT_FALSE(std::filesystem::exists(file.parent_path()));
}

TEST(Secret, IsAnotherOneEachTime) {
    std::set<std::string> secrets;
    for (int k = 0; k < 100; ++k)
        secrets.insert(secret());
    EXPECT_EQ(secrets.size(), 100U);
}

RC_GTEST_PROP(Secret, IsComparedAsTextIs, (const std::string& a, const std::string& b)) {
    RC_ASSERT(is_same_secret(a, b) == (a == b && !a.empty()));
    RC_ASSERT(is_same_secret(a, a) == !a.empty());
}

RC_GTEST_PROP(Parameter, IsFoundWhereverItStands, (const std::vector<std::string>& values)) {
    std::string query;
    for (std::size_t k = 0; k < values.size(); ++k) {
        std::string value = values[k];
        std::erase(value, '&');
        query += (k > 0 ? "&" : "") + ("k" + std::to_string(k)) + "=" + value;
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
        std::string value = values[k];
        std::erase(value, '&');
        RC_ASSERT(parameter(query, "k" + std::to_string(k), '&') == value);
    }
    RC_ASSERT(parameter(query, "none", '&').empty());
}

}  // namespace
}  // namespace stridor::explorer
