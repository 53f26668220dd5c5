#include "server_support.hpp"

namespace stridor::explorer {
namespace {

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
          std::string("POST / HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: xchunked\r\n\r\n3\r\nabc\r\n0\r\n\r\n"),
          std::string("POST / HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: gzip, chunked\r\n\r\n0\r\n\r\n"),
          std::string("POST / HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\nTransfer-Encoding: chunked\r\n\r\n"),
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
    // the server notices one by one that they have left
    EXPECT_TRUE(support::wait_until([&] { return is_alive(); }));
}

TEST_F(ServerTest, StopsTheWorkWhenTheClientGoesAway) {
    expect_that_leaving_stops_the_run("GET /long HTTP/1.1\r\nHost: a\r\n\r\n");
}

TEST_F(ServerTest, StopsTheWorkAtItsDeadline) {
    serve([&](const HttpRequest&, const std::stop_token& stop) {
        support::wait_for_stop(stop);
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
    serve([&](const HttpRequest&, const std::stop_token&) { return counting(30, made); });
    const std::string answer = ask("GET / HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n");
    EXPECT_NE(answer.find("Transfer-Encoding: chunked"), std::string::npos);
    EXPECT_NE(answer.find("part 29;"), std::string::npos);
    EXPECT_TRUE(answer.ends_with("0\r\n\r\n"));
    EXPECT_EQ(made, 30);
}

TEST_F(ServerTest, WaitsForASlowReaderAndGivesUpOnOneThatTakesNothing) {
    std::atomic<int> made = 0;
    std::promise<void> given_up;
    serve([&](const HttpRequest& request, const std::stop_token&) {
        if (request.path == "/alive") return plain(200, "GET /alive");
        Response response = counting(100000, made);
        response.stream = [&given_up, parts = response.stream](const Send& send, const std::stop_token& stop) {
            try {
                parts(send, stop);
            } catch (...) {
                given_up.set_value();
                throw;
            }
            given_up.set_value();
        };
        return response;
    });
    Client client(server_.port());
    client.send("GET / HTTP/1.1\r\nHost: a\r\n\r\n");
    EXPECT_EQ(given_up.get_future().wait_for(2min), std::future_status::ready);
    EXPECT_GT(made, 0);
    EXPECT_LT(made, 1000);  // the system's buffers hold the rest
    expect_alive();
}

TEST_F(ServerTest, ABodyThatIsCutOffIsNotTakenForAWholeOne) {
    serve([&](const HttpRequest&, const std::stop_token&) {
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
    serve([&](const HttpRequest&, const std::stop_token&) { return counting(1000000, made); });
    Client client(server_.port());
    client.send("GET / HTTP/1.1\r\nHost: a\r\n\r\n");
    client.receive("part 3;");
    const auto begin = std::chrono::steady_clock::now();
    stop_.request_stop();
    thread_.join();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 2s);
}

}  // namespace
}  // namespace stridor::explorer
