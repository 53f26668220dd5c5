#include "stridor/explorer/server.hpp"

#include "stridor/base/error.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <future>
#include <string>
#include <thread>

namespace stridor::explorer {
namespace {

using namespace std::chrono_literals;

// a client that speaks bytes, not HTTP
class Client {
public:
    explicit Client(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0) << std::strerror(errno);
    }
    explicit Client(const std::string& path) : socket_(::socket(AF_UNIX, SOCK_STREAM, 0)) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        path.copy(address.sun_path, sizeof address.sun_path - 1);
        EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0) << std::strerror(errno);
    }
    ~Client() { close(); }
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    void close() {
        if (socket_ >= 0) ::close(socket_);
        socket_ = -1;
    }

    // false once the server has closed its end, or takes nothing for two seconds
    bool send(const std::string& bytes) {
        std::size_t done = 0;
        while (done < bytes.size()) {
            pollfd ready{socket_, POLLOUT, 0};
            if (::poll(&ready, 1, 2000) != 1) return false;
            const ssize_t count =
                ::send(socket_, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL | MSG_DONTWAIT);
            if (count < 0) return false;
            done += static_cast<std::size_t>(count);
        }
        return true;
    }

    // what comes until `end` stands in it, the server closes its end, or nothing has come for a while
    std::string receive(const std::string& end = "", std::chrono::milliseconds patience = 5000ms) {
        std::string text;
        char buffer[65536];
        pollfd ready{socket_, POLLIN, 0};
        while (::poll(&ready, 1, static_cast<int>(patience.count())) == 1) {
            const ssize_t count = ::recv(socket_, buffer, sizeof buffer, 0);
            if (count <= 0) {
                is_closed_ = true;
                break;
            }
            text.append(buffer, static_cast<std::size_t>(count));
            if (!end.empty() && text.find(end) != std::string::npos) break;
        }
        return text;
    }

    bool is_closed() const { return is_closed_; }

private:
    int socket_;
    bool is_closed_ = false;
};

Limits small_limits() {
    Limits limits;
    limits.header = 4096;
    limits.body = 10000;
    limits.connections = 6;
    limits.idle = 400ms;
    limits.receiving = 300ms;
    limits.sending = 300ms;
    limits.working = 1000ms;
    limits.stopping = 300ms;
    return limits;
}

class ServerTest : public testing::Test {
protected:
    explicit ServerTest(const Address& address = {}) : server_(address, small_limits()) {}
    ~ServerTest() override {
        stop_.request_stop();
        if (thread_.joinable()) thread_.join();
    }

    void serve(Handler handler, Admit admit = {}) {
        handler_ = std::move(handler);
        admit_ = std::move(admit);
        thread_ = std::thread([this] { stuck_ = server_.serve(handler_, stop_.get_token(), admit_); });
    }

    void serve_echo() {
        serve([](const Request& request, const std::stop_token&) {
            return plain(200, request.method + " " + request.path + "?" + request.query + " " + request.host + " " +
                                  std::to_string(request.body.size()));
        });
    }

    std::string ask(const std::string& text, const std::string& end = "") {
        Client client(server_.port());
        client.send(text);
        return client.receive(end);
    }

    // the question every test of an attack ends with
    void expect_alive() {
        EXPECT_NE(ask("GET /alive HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n").find("GET /alive"),
                  std::string::npos);
    }

    Server server_;
    Handler handler_;
    Admit admit_;
    std::stop_source stop_;
    std::thread thread_;
    std::size_t stuck_ = 0;  // answers that outlived the server
};

TEST_F(ServerTest, AnswersWithTheHeadersThatKeepAPageApart) {
    serve_echo();
    const std::string answer = ask("GET /a/b?c=d HTTP/1.1\r\nHost: localhost:1\r\nConnection: close\r\n\r\n");
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 OK\r\n")) << answer;
    EXPECT_NE(answer.find("GET /a/b?c=d localhost:1 0"), std::string::npos) << answer;
    for (const auto& [name, value] : security_headers())
        EXPECT_NE(answer.find(std::string(name) + ": " + std::string(value)), std::string::npos) << name;
    EXPECT_EQ(answer.find("Access-Control"), std::string::npos);
}

TEST_F(ServerTest, AnswersOneRequestAfterTheOtherOnAConnection) {
    serve_echo();
    Client client(server_.port());
    for (int k = 0; k < 20; ++k) {
        const std::string path = "/" + std::to_string(k) + "?";
        client.send("POST " + path + " HTTP/1.1\r\nHost: a\r\nContent-Length: 3\r\n\r\nabc");
        EXPECT_NE(client.receive("a 3\n").find(path), std::string::npos);
    }
}

TEST_F(ServerTest, ReadsChunkedBodiesUpToTheLimit) {
    serve_echo();
    const std::string head = "POST / HTTP/1.1\r\nHost: a\r\nConnection: close\r\nTransfer-Encoding: chunked\r\n\r\n";
    EXPECT_NE(ask(head + "3\r\nabc\r\n2\r\nde\r\n0\r\n\r\n").find("a 5\n"), std::string::npos);
}

TEST_F(ServerTest, RefusesABodyOf600MegabytesAfterAFewKilobytes) {
    serve_echo();
    Client client(server_.port());
    client.send("POST / HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\n\r\n");
    const std::string chunk = "10000\r\n" + std::string(0x10000, 'x') + "\r\n";
    std::size_t taken = 0;
    while (taken < 600'000'000 && client.send(chunk))
        taken += chunk.size();
    // what the system's own buffers took is not the server's
    EXPECT_LT(taken, 20'000'000U);
    expect_alive();
    EXPECT_NE(ask("POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 600000000\r\n\r\n").find(" 413 "), std::string::npos);
    expect_alive();
}

TEST_F(ServerTest, RefusesThreeMillionHeaderLinesAfterAFew) {
    serve_echo();
    Client client(server_.port());
    client.send("GET / HTTP/1.1\r\nHost: a\r\n");
    std::string lines;
    for (int k = 0; k < 1000; ++k)
        lines += "X-Line: 1\r\n";
    std::size_t taken = 0;
    while (taken < 3'000'000 && client.send(lines))
        taken += 1000;
    EXPECT_LT(taken, 1'000'000U);
    expect_alive();
    EXPECT_NE(ask("GET /" + std::string(5000, 'a') + " HTTP/1.1\r\n\r\n").find(" 431 "), std::string::npos);
    expect_alive();
}

TEST_F(ServerTest, CountsHeaderLinesWhateverTheirLength) {
    serve_echo();
    std::string lines;
    for (int k = 0; k < 300; ++k)
        lines += "X:1\r\n";
    EXPECT_NE(ask("GET / HTTP/1.1\r\nHost: a\r\n" + lines + "\r\n").find(" 431 "), std::string::npos);
    expect_alive();
}

TEST_F(ServerTest, RefusesWhatIsNoHttp) {
    serve_echo();
    const std::string chunked = "POST / HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\n\r\n";
    for (const std::string& text :
         {std::string("hello\r\n\r\n"), std::string("GET / HTTP/9.9\r\n\r\n"), chunked + "-2\r\nab\r\n",
          chunked + "zz\r\n", chunked + "ffffffffffffffffff\r\nab",
          std::string("GET / HTTP/1.1\r\nContent-Length: -5\r\n\r\n"),
          std::string("GET / HTTP/1.1\r\nContent-Length: 1\r\nContent-Length: 2\r\n\r\nab"),
          std::string("GET / HTTP/1.1\r\nContent-Length: 1\r\nTransfer-Encoding: chunked\r\n\r\nab"),
          std::string("GET /\x01 HTTP/1.1\r\n\r\n"), std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11)}) {
        const std::string answer = ask(text);
        EXPECT_TRUE(answer.empty() || answer.find(" 400 ") != std::string::npos ||
                    answer.find(" 413 ") != std::string::npos)
            << text << answer;
        expect_alive();
    }
}

TEST_F(ServerTest, TakesARequestWithTwoHostsForOneOfNone) {
    serve_echo();
    const std::string answer = ask("GET / HTTP/1.1\r\nHost: localhost\r\nHost: evil\r\nConnection: close\r\n\r\n");
    EXPECT_TRUE(answer.find("GET /?  0") != std::string::npos || answer.find(" 400 ") != std::string::npos) << answer;
}

TEST_F(ServerTest, ClosesOnTheSlow) {
    serve_echo();
    Client silent(server_.port());
    Client slow(server_.port());
    slow.send("GET / HT");
    Client lazy(server_.port());
    lazy.send("POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 100\r\n\r\nabc");
    for (Client* client : {&silent, &slow, &lazy}) {
        client->receive("", 3000ms);
        EXPECT_TRUE(client->is_closed());
    }
    expect_alive();
}

TEST_F(ServerTest, DripsOfBytesDoNotKeepARequestOpen) {
    serve_echo();
    Client client(server_.port());
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < 5s && client.send("G") && client.receive("", 50ms).empty() &&
           !client.is_closed()) {
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 3s);
    expect_alive();
}

TEST_F(ServerTest, ClosesConnectionsBeyondTheLimitAndServesAgainOnceOthersLeave) {
    serve_echo();
    std::vector<std::unique_ptr<Client>> clients;
    for (int k = 0; k < 40; ++k)
        clients.push_back(std::make_unique<Client>(server_.port()));
    int closed = 0;
    for (const auto& client : clients) {
        client->receive("", 5ms);
        closed += client->is_closed() ? 1 : 0;
    }
    EXPECT_GE(closed, 30);
    clients.clear();
    std::this_thread::sleep_for(100ms);
    expect_alive();
}

TEST_F(ServerTest, StopsTheWorkWhenTheClientGoesAway) {
    std::promise<void> begun;
    std::promise<bool> stopped;
    serve([&](const Request& request, const std::stop_token& stop) {
        if (request.path == "/alive") return plain(200, "GET /alive");
        begun.set_value();
        const auto end = std::chrono::steady_clock::now() + 900ms;
        while (!stop.stop_requested() && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(1ms);
        stopped.set_value(std::chrono::steady_clock::now() < end);
        return plain(200, "late");
    });
    Client client(server_.port());
    client.send("GET /long HTTP/1.1\r\nHost: a\r\n\r\n");
    begun.get_future().wait();
    client.close();
    EXPECT_TRUE(stopped.get_future().get());
    expect_alive();
}

TEST_F(ServerTest, StopsTheWorkAtItsDeadline) {
    serve([&](const Request&, const std::stop_token& stop) {
        while (!stop.stop_requested())
            std::this_thread::sleep_for(1ms);
        return plain(503, "too long");
    });
    EXPECT_NE(ask("GET / HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n").find("too long"), std::string::npos);
}

// part after part, each of which names its number
Response counting(int parts, std::atomic<int>& made) {
    Response response;
    response.stream = [parts, &made](const Send& send, const std::stop_token& stop) {
        for (int k = 0; k < parts && !stop.stop_requested(); ++k) {
            send("part " + std::to_string(k) + ";" + std::string(100000, '.'));
            ++made;
        }
    };
    return response;
}

TEST_F(ServerTest, StreamsPartsAsTheyAreMade) {
    std::atomic<int> made = 0;
    serve([&](const Request&, const std::stop_token&) { return counting(30, made); });
    const std::string answer = ask("GET / HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n");
    EXPECT_NE(answer.find("Transfer-Encoding: chunked"), std::string::npos);
    EXPECT_NE(answer.find("part 29;"), std::string::npos);
    EXPECT_TRUE(answer.ends_with("0\r\n\r\n"));
    EXPECT_EQ(made, 30);
}

TEST_F(ServerTest, WaitsForASlowReaderAndGivesUpOnOneThatTakesNothing) {
    std::atomic<int> made = 0;
    serve([&](const Request& request, const std::stop_token&) {
        return request.path == "/alive" ? plain(200, "GET /alive") : counting(100000, made);
    });
    Client client(server_.port());
    client.send("GET / HTTP/1.1\r\nHost: a\r\n\r\n");
    std::this_thread::sleep_for(1500ms);
    const int before = made;
    EXPECT_LT(before, 1000);  // the system's buffers hold the rest
    std::this_thread::sleep_for(300ms);
    EXPECT_EQ(made, before);
    expect_alive();
}

TEST_F(ServerTest, ABodyThatIsCutOffIsNotTakenForAWholeOne) {
    serve([&](const Request&, const std::stop_token&) {
        Response response;
        response.stream = [](const Send& send, const std::stop_token&) {
            send("begun");
            throw std::runtime_error("and failed");
        };
        return response;
    });
    const std::string answer = ask("GET / HTTP/1.1\r\nHost: a\r\n\r\n");
    EXPECT_FALSE(answer.ends_with("0\r\n\r\n")) << answer;
}

TEST_F(ServerTest, EndsWhileRequestsAreBeingAnswered) {
    std::atomic<int> made = 0;
    serve([&](const Request&, const std::stop_token&) { return counting(1000000, made); });
    Client client(server_.port());
    client.send("GET / HTTP/1.1\r\nHost: a\r\n\r\n");
    client.receive("part 3;");
    const auto begin = std::chrono::steady_clock::now();
    stop_.request_stop();
    thread_.join();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 2s);
}

constexpr const char* alive = "GET /alive HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n";

// answers that look at no token, until they are let go
class Deaf {
public:
    Handler handler() {
        return [state = state_](const Request& request, const std::stop_token&) {
            if (request.path == "/alive") return plain(200, "GET /alive");
            ++state->begun;
            while (!state->is_over)
                std::this_thread::sleep_for(1ms);
            --state->begun;
            return plain(200, "late");
        };
    }
    void wait_for(int begun) const {
        while (state_->begun < begun)
            std::this_thread::sleep_for(1ms);
    }
    ~Deaf() {
        state_->is_over = true;
        while (state_->begun > 0)
            std::this_thread::sleep_for(1ms);
    }

private:
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
    std::promise<void> begun;
    std::promise<bool> stopped;
    serve([&](const Request& request, const std::stop_token& stop) {
        if (request.path == "/alive") return plain(200, "GET /alive");
        begun.set_value();
        const auto end = std::chrono::steady_clock::now() + 900ms;
        while (!stop.stop_requested() && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(1ms);
        stopped.set_value(std::chrono::steady_clock::now() < end);
        return plain(200, "late");
    });
    Client client(server_.port());
    client.send("GET /long HTTP/1.1\r\nHost: a\r\n\r\nGET /next HT");
    begun.get_future().wait();
    client.close();
    EXPECT_TRUE(stopped.get_future().get());
    expect_alive();
}

// the owner's requests say so; nobody else's are let through
Admit owner_only() {
    return [](const Request& request) -> std::optional<Response> {
        if (request.cookie == "owner") return std::nullopt;
        return plain(401, "who are you?");
    };
}

TEST_F(ServerTest, StrangersWhoSayNothingKeepTheOwnerNeitherOutNorDisconnected) {
    serve([](const Request&, const std::stop_token&) { return plain(200, "at your service"); }, owner_only());
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
    const Handler handler = [](const Request& request, const std::stop_token&) {
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
        const Handler handler = [](const Request&, const std::stop_token&) { return plain(200, "through the file"); };
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
