#pragma once

#include "stridor/explorer/http.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>

namespace stridor::explorer {

/// Where to listen.
struct Address {
    std::string host = "127.0.0.1";       // an address of this machine, no name
    std::uint16_t port = 0;               // 0: any free one
    std::filesystem::path unix_socket{};  // if given, instead: a socket in the file system, for its owner alone
};

/// What one client may ask of the server.
struct Limits {
    std::size_t header = 16 * 1024;              // [B]
    std::size_t body = 1024 * 1024;              // [B]
    std::size_t connections = 64;                // [1] more are closed at once
    std::size_t requests = 16;                   // [1] being answered at a time; more are told to come back
    std::chrono::milliseconds idle{60000};       // between two requests
    std::chrono::milliseconds receiving{15000};  // for one request to arrive in full
    std::chrono::milliseconds sending{30000};    // for one part of an answer to be taken
    std::chrono::milliseconds working{120000};   // for one answer to be made
};

/// An HTTP/1.1 server (Boost.Beast) for few clients: one thread carries bytes, a few make answers.
///
/// What exceeds a limit is refused (413, 431, 503) or closed; memory stays bounded by the limits whatever clients send.
class Server {
public:
    /// Listens at once. Throws `Error` (input) for an address that is none, (io) for one that cannot be had.
    explicit Server(const Address& address, const Limits& limits = {});
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    /// The port that it listens at; 0 with a socket in the file system.
    std::uint16_t port() const;

    /// Answers requests until stopped. Once.
    void serve(const Handler& handler, const std::stop_token& stop);

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Is it an address that only this machine reaches?
bool is_loopback(const std::string& host);

}  // namespace stridor::explorer
