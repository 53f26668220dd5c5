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

/// The address of the server.
struct Address {
    std::string host = "127.0.0.1";       // an address of this machine, no name
    std::uint16_t port = 0;               // 0: any free one
    std::filesystem::path unix_socket{};  // if given, instead: a socket in the file system, for its owner alone
};

/// The limits of the server for its clients.
struct Limits {
    std::size_t header = 1024 * 1024;       // [B] browsers send the cookies of all who share the host: up to 720 kB
    std::size_t header_lines = 200;         // [1] each takes memory of its own
    std::size_t body = 1024 * 1024;         // [B]
    std::size_t connections = 64;           // [1] for more, the longest silent ones are closed: see `serve`
    std::size_t requests = 16;              // [1] being answered at a time; more are told to come back
    std::size_t workers = 4;                // [1] of them being made at a time
    std::size_t given_up = 8;               // [1] workers that did not stop when they were told to
    std::chrono::milliseconds idle{60000};  // between two requests
    std::chrono::milliseconds receiving{15000};  // for one request to arrive in full
    std::chrono::milliseconds sending{30000};    // for one part of an answer to be taken
    std::chrono::milliseconds working{120000};   // for one answer to be made
    std::chrono::milliseconds stopping{1500};    // for a worker to stop once its request is; then it is given up
};

/// An HTTP/1.1 server (Boost.Beast) for few clients: one thread carries bytes, a few make answers.
///
/// Requests beyond a limit are refused (413, 431, 503) or closed; memory stays bounded by the limits, whatever clients
/// send.
///
/// An answer is stopped when its client leaves, its time is over or the server ends. An answer that does not stop in
/// time is given up: another one gets its place, but nobody gets its thread. Ending waits for such threads no longer
/// than for the others.
class Server {
public:
    /// Listens at once. Pages of `frame_origin` may show it in a frame; empty: none. Throws `Error` (input) for an
    /// invalid address, (io) for one that is not available.
    explicit Server(const Address& address, const Limits& limits = {}, const std::string& frame_origin = {});
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    /// Returns its port; 0 with a socket in the file system.
    std::uint16_t port() const;

    /// Answers requests until stopped. May be called once.
    ///
    /// Connections over which `admit` has let a request through have priority: if there are too many connections, the
    /// oldest of the others is closed, so that silent strangers keep nobody out.
    ///
    /// Returns the number of answers still being made, by threads that did not stop. If there are any, the objects that
    /// the handler uses must outlive them, or the program must end at once.
    std::size_t serve(const Handler& handler, const std::stop_token& stop, const Admit& admit = {});

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Says whether only this machine reaches an address.
bool is_loopback(const std::string& host);

/// Throws `Error` (input) for an address that other machines reach.
void require_loopback(const std::string& address);

}  // namespace stridor::explorer
