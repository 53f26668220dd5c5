#include "stridor/explorer/framing_site.hpp"

#include "server_support.hpp"

#include <algorithm>

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

}  // namespace
}  // namespace stridor::explorer
