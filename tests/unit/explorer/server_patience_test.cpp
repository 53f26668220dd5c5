// Whom the server waits for, and for how long: runs that do not stop, strangers, its own end.

#include "server_support.hpp"

namespace stridor::explorer {
namespace {

constexpr const char* alive = "GET /alive HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n";

// answers that look at no token, until they are let go
class Deaf {
public:
    Handler handler() {
        return [state = state_](const HttpRequest& request, const std::stop_token&) {
            if (request.path == "/alive") return plain(200, "GET /alive");
            change(state->begun, 1);
            state->is_over.wait(false);
            change(state->begun, -1);
            return plain(200, "late");
        };
    }
    void wait_for(int begun) const {
        for (int now = state_->begun; now < begun; now = state_->begun)
            state_->begun.wait(now);
    }
    ~Deaf() {
        state_->is_over = true;
        state_->is_over.notify_all();
        for (int now = state_->begun; now > 0; now = state_->begun)
            state_->begun.wait(now);
    }

private:
    static void change(std::atomic<int>& number, int by) {
        number += by;
        number.notify_all();
    }

    struct State {
        std::atomic<int> begun = 0;
        std::atomic<bool> is_over = false;
    };
    std::shared_ptr<State> state_ = std::make_shared<State>();  // which the threads that are given up share
};

TEST_F(ServerTest, RunsThatDoNotStopWhenTheirClientsLeaveKeepNobodyWaiting) {
    Deaf deaf;
    serve(deaf.handler());
    for (int round = 0; round < 2; ++round) {
        std::vector<std::unique_ptr<Client>> clients;
        for (int k = 0; k < 4; ++k) {
            clients.push_back(std::make_unique<Client>(server_.port()));
            clients.back()->send("GET /deaf HTTP/1.1\r\nHost: a\r\n\r\n");
        }
        deaf.wait_for(4 * (round + 1));
        clients.clear();
        expect_alive();
    }
    const auto begin = std::chrono::steady_clock::now();
    stop_.request_stop();
    thread_.join();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 2s);
    EXPECT_EQ(stuck_, 8U);
}

TEST_F(ServerTest, ARunThatDoesNotStopAtItsDeadlineIsAnsweredForIt) {
    Deaf deaf;
    serve(deaf.handler());
    EXPECT_NE(ask("GET /deaf HTTP/1.1\r\nHost: a\r\n\r\n").find(" 503 "), std::string::npos);
    expect_alive();
}

TEST_F(ServerTest, SaysWhatToDoOnceTooManyRunsDoNotStop) {
    Deaf deaf;
    serve(deaf.handler());
    // eight are given up, four more hold the workers
    for (int k = 0; k < 12; ++k) {
        Client client(server_.port());
        client.send("GET /deaf HTTP/1.1\r\nHost: a\r\n\r\n");
        deaf.wait_for(k + 1);
    }
    EXPECT_NE(ask(alive).find("End stridor in its terminal"), std::string::npos);
    stop_.request_stop();
    thread_.join();
    EXPECT_EQ(stuck_, 12U);
}

TEST_F(ServerTest, NoticesAClientThatLeavesBehindBytesItSent) {
    expect_that_leaving_stops_the_run("GET /long HTTP/1.1\r\nHost: a\r\n\r\nGET /next HT");
}

// the owner's requests say so; nobody else's are let through
Admit owner_only() {
    return [](const HttpRequest& request) -> std::optional<Response> {
        if (request.cookie == "owner") return std::nullopt;
        return plain(401, "who are you?");
    };
}

TEST_F(ServerTest, StrangersWhoSayNothingKeepTheOwnerNeitherOutNorDisconnected) {
    serve([](const HttpRequest&, const std::stop_token&) { return plain(200, "at your service"); }, owner_only());
    const std::string request = "GET / HTTP/1.1\r\nHost: a\r\nCookie: owner\r\n\r\n";
    Client before(server_.port());
    before.send(request);
    EXPECT_NE(before.receive("service").find("at your service"), std::string::npos);
    std::vector<std::unique_ptr<Client>> strangers;
    for (int k = 0; k < 100; ++k) {
        strangers.push_back(std::make_unique<Client>(server_.port()));
        if (k % 3 == 1) strangers.back()->send("GET / HTTP/1.1\r\nHo");
        if (k % 3 == 2) strangers.back()->send("GET / HTTP/1.1\r\nHost: a\r\nCookie: stranger\r\n\r\n");
    }
    Client after(server_.port());
    after.send(request);
    EXPECT_NE(after.receive("service").find("at your service"), std::string::npos) << "the owner is kept out";
    before.send(request);
    EXPECT_NE(before.receive("service").find("at your service"), std::string::npos) << "the owner was thrown out";
}

TEST_F(ServerTest, RefusesStrangersWhileAllWorkersAreBusy) {
    Deaf deaf;
    serve(deaf.handler(), owner_only());
    std::vector<std::unique_ptr<Client>> clients;
    for (int k = 0; k < 4; ++k) {
        clients.push_back(std::make_unique<Client>(server_.port()));
        clients.back()->send("GET /deaf HTTP/1.1\r\nHost: a\r\nCookie: owner\r\n\r\n");
    }
    deaf.wait_for(4);
    Client stranger(server_.port());
    stranger.send(alive);
    EXPECT_NE(stranger.receive("", 500ms).find(" 401 "), std::string::npos);
}

// browsers send 180 cookies of 4 kB each to a host, whoever set them
TEST(ServerLimits, LeaveRoomForTheCookiesOfOthers) {
    Server server({"127.0.0.1", 0, {}});
    std::stop_source stop;
    const Handler handler = [](const HttpRequest& request, const std::stop_token&) {
        return plain(200, std::to_string(request.cookie.size()) + " bytes of cookies");
    };
    std::thread thread([&] { server.serve(handler, stop.get_token()); });
    std::string cookies = "stridor-1=x";
    for (int k = 0; k < 180; ++k)
        cookies += "; c" + std::to_string(k) + "=" + std::string(4080, 'x');
    Client client(server.port());
    client.send("GET / HTTP/1.1\r\nHost: a\r\nConnection: close\r\nCookie: " + cookies + "\r\n\r\n");
    EXPECT_NE(client.receive().find(std::to_string(cookies.size()) + " bytes of cookies"), std::string::npos);
    stop.request_stop();
    thread.join();
}

TEST(ServerAddress, IsAnAddressThatCanBeHad) {
    using support::thrown_by;
    EXPECT_EQ(thrown_by([] { Server({"not an address", 0, {}}); }).kind, ErrorKind::input);
    const Server first({"127.0.0.1", 0, {}});
    EXPECT_GT(first.port(), 0);
    EXPECT_EQ(thrown_by([&] { Server({"127.0.0.1", first.port(), {}}); }).kind, ErrorKind::io);
    EXPECT_TRUE(is_loopback("127.0.0.1"));
    EXPECT_TRUE(is_loopback("127.9.8.7"));
    EXPECT_TRUE(is_loopback("::1"));
    for (const char* host : {"0.0.0.0", "::", "192.168.1.2", "localhost", ""})
        EXPECT_FALSE(is_loopback(host)) << host;
    EXPECT_NO_THROW(require_loopback("127.0.0.1"));
    EXPECT_TRUE(thrown_by([] { require_loopback("0.0.0.0"); }).says("can be reached from other machines"));
}

TEST(UnixSocket, IsForItsOwnerAloneAndGoesWithTheServer) {
    const support::ScratchFolder folder;
    const std::string path = (folder / "explorer.sock").string();
    {
        Server server({"127.0.0.1", 0, path}, small_limits());
        struct stat status {};
        ASSERT_EQ(::stat(path.c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777U, 0600U);
        std::stop_source stop;
        const Handler handler = [](const HttpRequest&, const std::stop_token&) {
            return plain(200, "through the file");
        };
        std::thread thread([&] { server.serve(handler, stop.get_token()); });
        Client client(path);
        client.send("GET / HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
        EXPECT_NE(client.receive().find("through the file"), std::string::npos);
        EXPECT_EQ(support::thrown_by([&] { Server({"127.0.0.1", 0, path}); }).kind, ErrorKind::io);
        stop.request_stop();
        thread.join();
    }
    EXPECT_NE(::access(path.c_str(), F_OK), 0);
}

}  // namespace
}  // namespace stridor::explorer
