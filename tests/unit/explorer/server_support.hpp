#pragma once

#include "stridor/base/error.hpp"
#include "stridor/explorer/server.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"
#include "support/wait.hpp"

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

inline Limits small_limits() {
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
        serve([](const HttpRequest& request, const std::stop_token&) {
            return plain(200, request.method + " " + request.path + "?" + request.query + " " + request.host + " " +
                                  std::to_string(request.body.size()));
        });
    }

    // a run that ends once it is told to, or after 0.9 s; `stopped_` says which
    void serve_one_run() {
        serve([this](const HttpRequest& request, const std::stop_token& stop) {
            if (request.path == "/alive") return plain(200, "GET /alive");
            begun_.set_value();
            stopped_.set_value(support::wait_for_stop(stop, 900ms));
            return plain(200, "late");
        });
    }

    // a client asks for the run with these bytes and leaves while it is made
    void expect_that_leaving_stops_the_run(const std::string& bytes) {
        serve_one_run();
        Client client(server_.port());
        client.send(bytes);
        begun_.get_future().wait();
        client.close();
        EXPECT_TRUE(stopped_.get_future().get());
        expect_alive();
    }

    std::string ask(const std::string& text, const std::string& end = "") {
        Client client(server_.port());
        client.send(text);
        return client.receive(end);
    }

    // the question every test of an attack ends with
    bool is_alive() {
        const std::string answer = ask("GET /alive HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n");
        return answer.find("GET /alive") != std::string::npos;
    }
    void expect_alive() { EXPECT_TRUE(is_alive()); }

    Server server_;
    Handler handler_;
    Admit admit_;
    std::promise<void> begun_;
    std::promise<bool> stopped_;
    std::stop_source stop_;
    std::thread thread_;
    std::size_t stuck_ = 0;  // answers that outlived the server
};

}  // namespace stridor::explorer
