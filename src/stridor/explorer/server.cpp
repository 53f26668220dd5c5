#include "stridor/explorer/server.hpp"

#include "stridor/base/error.hpp"
#include "stridor/explorer/connection.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <sys/stat.h>
#include <sys/un.h>

#include <optional>
#include <utility>

namespace stridor::explorer {

using asio::ip::tcp;
using Local = asio::local::stream_protocol;
using Acceptor = asio::basic_socket_acceptor<Stream>;

namespace {

void accept(Acceptor& acceptor, Shared& shared) {
    acceptor.async_accept([&](error_code error, Stream::socket socket) {
        if (error == asio::error::operation_aborted) return;
        const bool is_full = shared.connections >= shared.limits.connections;
        const bool makes_room = is_full && !shared.strangers.empty();
        if (!error && makes_room) shared.strangers.front()->close();
        if (!error && (!is_full || makes_room)) std::make_shared<Connection>(std::move(socket), shared)->read();
        if (!error) return accept(acceptor, shared);
        // out of file descriptors, say: trying again at once would only keep a processor busy
        shared.pause.expires_after(std::chrono::milliseconds(100));
        shared.pause.async_wait([&](error_code stopped) {
            if (!stopped) accept(acceptor, shared);
        });
    });
}

[[noreturn]] void refuse(const std::string& place, const error_code& error, std::string suggestion) {
    throw Error(ErrorKind::io, {"the explorer cannot listen at " + place, error.message(), std::move(suggestion)});
}

tcp::acceptor listen_at(asio::io_context& io, const Address& address) {
    error_code error;
    const auto host = asio::ip::make_address(address.host, error);
    if (error)
        throw Error(ErrorKind::input, {"'" + address.host + "' is no address",
                                       "an IP address of this machine is wanted", "Use 127.0.0.1, or leave it out."});
    const tcp::endpoint endpoint(host, address.port);
    tcp::acceptor acceptor(io);
    acceptor.open(endpoint.protocol());
    acceptor.set_option(asio::socket_base::reuse_address(true));
    acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error)
        refuse(address.host + ", port " + std::to_string(address.port), error,
               "Choose another --port; without one, any free one is taken.");
    return acceptor;
}

// a socket nobody listens at any more is replaced, nothing else
void remove_stale(asio::io_context& io, const std::filesystem::path& path) {
    if (!std::filesystem::is_socket(path)) return;
    error_code error;
    Local::socket(io).connect(Local::endpoint(path.string()), error);
    if (error == asio::error::connection_refused) std::filesystem::remove(path);
}

Local::acceptor listen_at(asio::io_context& io, const std::filesystem::path& path) {
    constexpr std::size_t longest = sizeof(sockaddr_un::sun_path) - 1;
    if (path.string().size() > longest)
        throw Error(ErrorKind::input,
                    {"the path of the socket is too long: " + path.string(),
                     "systems take at most " + std::to_string(longest) + " bytes", "Choose a shorter one."});
    error_code error;
    remove_stale(io, path);
    Local::acceptor acceptor(io);
    acceptor.open();
    const ::mode_t before = ::umask(0177);  // for the owner alone, from the first moment on
    acceptor.bind(Local::endpoint(path.string()), error);
    ::umask(before);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error) refuse(path.string(), error, "Choose another path, one that is not there yet.");
    return acceptor;
}

}  // namespace

class Server::Implementation {
public:
    Implementation(const Address& address, const Limits& limits, const std::string& frame_origin)
        : shared(std::make_shared<Shared>(limits, frame_origin)),
          socket_path(address.unix_socket) {
        if (!socket_path.empty()) {
            acceptor.emplace(listen_at(shared->io, socket_path));
            return;
        }
        tcp::acceptor listening = listen_at(shared->io, address);
        port = listening.local_endpoint().port();
        acceptor.emplace(std::move(listening));
    }
    ~Implementation() {
        std::error_code ignored;
        if (!socket_path.empty()) std::filesystem::remove(socket_path, ignored);
    }
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;

    std::size_t serve(const Handler& handler, const std::stop_token& stop, const Admit& admit) {
        shared->handler = handler;
        shared->admit = admit;
        accept(*acceptor, *shared);
        const std::stop_callback end(stop, [&] {
            shared->stop.request_stop();
            shared->io.stop();
        });
        while (!shared->io.stopped()) {
            try {
                shared->io.run();
            } catch (const std::exception&) {
                // a connection that throws (out of memory, say) is lost by that; the others go on
            }
        }
        return shared->join();
    }

    std::shared_ptr<Shared> shared;
    std::filesystem::path socket_path;  // empty: TCP
    std::optional<Acceptor> acceptor;
    std::uint16_t port = 0;
};

Server::Server(const Address& address, const Limits& limits, const std::string& frame_origin)
    : implementation_(new Implementation(address, limits, frame_origin)) {}

Server::~Server() = default;

std::uint16_t Server::port() const {
    return implementation_->port;
}

std::size_t Server::serve(const Handler& handler, const std::stop_token& stop, const Admit& admit) {
    return implementation_->serve(handler, stop, admit);
}

bool is_loopback(const std::string& host) {
    error_code error;
    const auto address = asio::ip::make_address(host, error);
    return !error && address.is_loopback();
}

void require_loopback(const std::string& address) {
    if (is_loopback(address)) return;
    throw Error(ErrorKind::input,
                {address + " can be reached from other machines",
                 "whoever has the link could use the explorer, over a connection that is not encrypted",
                 "Leave --address out and use a tunnel (ssh -L), or add --allow-remote if that is what you want."});
}

}  // namespace stridor::explorer
