#include "stridor/explorer/server.hpp"

#include "stridor/base/error.hpp"
#include "stridor/explorer/parts.hpp"

// The only file that includes Boost: it takes long to compile.
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <sys/stat.h>
#include <sys/un.h>

#include <atomic>
#include <functional>
#include <optional>
#include <utility>

namespace stridor::explorer {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::ip::tcp;
using boost::system::error_code;
using Local = asio::local::stream_protocol;
using Stream = asio::generic::stream_protocol;  // either of them: one copy of all that follows
using Acceptor = asio::basic_socket_acceptor<Stream>;

namespace {

// what all connections share; lives as long as the server
struct Shared {
    const Limits limits;
    const Handler* handler = nullptr;
    std::stop_source stop{};  // of the whole server
    std::atomic<std::size_t> connections = 0;
    std::size_t requests = 0;  // touched by the io thread only
    asio::io_context io{1};    // one thread runs it: whatever is not handed to `pool` happens there
    asio::steady_timer pause{io};
    asio::thread_pool pool{4};  // makes answers; the last, so that what it still holds goes first
};

std::string text(beast::string_view view) {
    return {view.data(), view.size()};
}

Request request_of(http::request<http::string_body>&& message) {
    Request request;
    request.method = text(message.method_string());
    const std::string target = text(message.target());
    const std::size_t mark = target.find('?');
    request.path = target.substr(0, mark);
    if (mark != std::string::npos) request.query = target.substr(mark + 1);
    request.host = text(message[http::field::host]);
    request.origin = text(message[http::field::origin]);
    request.fetch_site = text(message["Sec-Fetch-Site"]);
    request.cookie = text(message[http::field::cookie]);
    request.content_type = text(message[http::field::content_type]);
    // a second Host or Origin would leave it to chance which one is looked at
    for (const auto name : {http::field::host, http::field::origin})
        if (message.count(name) > 1) request.host.clear();
    request.body = std::move(message.body());
    return request;
}

// an answer being made: stopped with the server, by its deadline or when its client goes away
class Work {
public:
    explicit Work(Shared& shared)
        : deadline(shared.io, shared.limits.working),
          relay_(shared.stop.get_token(), [this] { source_.request_stop(); }) {}

    void stop() { source_.request_stop(); }
    std::stop_token token() const { return source_.get_token(); }

    asio::steady_timer deadline;

private:
    std::stop_source source_;
    std::stop_callback<std::function<void()>> relay_;
};

// one client: reads a request, has it answered, sends the answer, and so on
class Connection : public std::enable_shared_from_this<Connection> {
    // the action, keeping this connection alive until it is done
    template <typename Action>
    auto own(Action action) {
        return [self = shared_from_this(), action = std::move(action)](auto&&... arguments) mutable {
            action(std::forward<decltype(arguments)>(arguments)...);
        };
    }

public:
    Connection(Stream::socket socket, Shared& shared) : shared_(shared), stream_(std::move(socket)) {
        ++shared_.connections;
    }
    ~Connection() { --shared_.connections; }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    // the first byte may take its time, the rest of the request may not
    void read() {
        parser_.emplace();
        parser_->header_limit(static_cast<std::uint32_t>(shared_.limits.header));
        parser_->body_limit(shared_.limits.body);
        if (buffer_.size() > 0) return receive();
        stream_.expires_after(shared_.limits.idle);
        stream_.async_read_some(buffer_.prepare(4096), own([this](error_code error, std::size_t bytes) {
                                    if (error) return;
                                    buffer_.commit(bytes);
                                    receive();
                                }));
    }

private:
    void receive() {
        stream_.expires_after(shared_.limits.receiving);
        http::async_read(stream_, buffer_, *parser_, own([this](error_code error, std::size_t) { received(error); }));
    }

    void received(error_code error) {
        if (!error) return answer();
        keep_alive_ = false;
        if (error == http::error::body_limit)
            send(plain(413, "The request is too large."));
        else if (error == http::error::header_limit || error == http::error::buffer_overflow)
            send(plain(431, "The request's header is too large."));
        else if (error.category() == error_code(http::error::bad_method).category() &&
                 error != http::error::end_of_stream && error != http::error::partial_message)
            send(plain(400, "This is no HTTP request: " + error.message() + "."));
        // else the client is gone or too slow
    }

    void answer() {
        keep_alive_ = parser_->get().keep_alive();
        if (shared_.requests >= shared_.limits.requests) return send(plain(503, "Busy; try again in a moment."));
        ++shared_.requests;
        const auto work = std::make_shared<Work>(shared_);
        work_ = work;
        work->deadline.async_wait([weak = std::weak_ptr(work)](error_code error) {
            if (const auto late = weak.lock(); late && !error) late->stop();
        });
        watch();
        asio::post(shared_.pool, own([this, work, request = request_of(parser_->release())] { make(request, work); }));
    }

    // readable without a byte to read: the client has closed its end
    void watch() {
        stream_.socket().async_wait(Stream::socket::wait_read, own([this, work = work_](error_code error) {
                                        error_code ignored;
                                        const auto current = work.lock();
                                        if (current && !error && stream_.socket().available(ignored) == 0)
                                            current->stop();
                                    }));
    }

    // nobody will read what is being made
    void lose() {
        if (const auto work = work_.lock()) work->stop();
    }

    // on a thread of the pool
    void make(const Request& request, const std::shared_ptr<Work>& work) {
        Response response = plain(500, "The explorer failed to answer; its terminal may say more.");
        try {
            response = (*shared_.handler)(request, work->token());
        } catch (...) {
        }
        const auto stream = std::exchange(response.stream, nullptr);
        if (!stream)
            return asio::post(shared_.io, own([this, work, response = std::move(response)]() mutable {
                                  finish(work);
                                  send(std::move(response));
                              }));
        const auto parts = std::make_shared<Parts>();
        asio::post(shared_.io, own([this, parts, response = std::move(response)] { begin(response, parts); }));
        bool is_whole = true;
        try {
            stream(
                [&](std::string part) {
                    parts->push(std::move(part), work->token());
                    asio::post(shared_.io, own([this, parts] { send_next(parts); }));
                },
                work->token());
        } catch (...) {
            is_whole = false;
        }
        if (work->token().stop_requested()) is_whole = false;
        asio::post(shared_.io, own([this, work, parts, is_whole] {
                       finish(work);
                       // a client takes a body without its last chunk as cut off
                       if (!is_whole) return stream_.close();
                       parts->end();
                       send_next(parts);
                   }));
    }

    void finish(const std::shared_ptr<Work>& work) {
        work->deadline.cancel();
        --shared_.requests;
    }

    template <typename Body>
    void put_fields(http::response<Body>& message, const Response& response) {
        message.result(static_cast<unsigned>(response.status));
        message.version(11);
        message.keep_alive(keep_alive_);
        for (const auto& [name, value] : security_headers())
            message.set(beast::string_view(name.data(), name.size()), beast::string_view(value.data(), value.size()));
        for (const auto& [name, value] : response.headers)
            message.set(name, value);
        message.set(http::field::content_type, response.content_type);
    }

    void send(Response response) {
        const auto message = std::make_shared<http::response<http::string_body>>();
        put_fields(*message, response);
        message->body() = std::move(response.body);
        message->prepare_payload();
        stream_.expires_after(shared_.limits.sending);
        http::async_write(stream_, *message, own([this, message](error_code error, std::size_t) { sent(error); }));
    }

    void begin(const Response& response, const std::shared_ptr<Parts>& parts) {
        const auto message = std::make_shared<http::response<http::empty_body>>();
        put_fields(*message, response);
        message->chunked(true);
        const auto header = std::make_shared<http::response_serializer<http::empty_body>>(*message);
        is_sending_ = true;
        stream_.expires_after(shared_.limits.sending);
        http::async_write_header(stream_, *header, own([this, message, header, parts](error_code error, std::size_t) {
                                     is_sending_ = false;
                                     error ? lose() : send_next(parts);
                                 }));
    }

    void send_next(const std::shared_ptr<Parts>& parts) {
        if (is_sending_) return;
        stream_.expires_after(shared_.limits.sending);
        if (const std::string* part = parts->front()) {
            is_sending_ = true;
            asio::async_write(stream_, http::make_chunk(asio::buffer(*part)),
                              own([this, parts](error_code error, std::size_t) {
                                  is_sending_ = false;
                                  if (error) return lose();
                                  parts->pop();
                                  send_next(parts);
                              }));
        } else if (parts->has_ended()) {
            is_sending_ = true;
            asio::async_write(stream_, http::make_chunk_last(), own([this](error_code error, std::size_t) {
                                  is_sending_ = false;
                                  sent(error);
                              }));
        }
    }

    void sent(error_code error) {
        if (error) return;
        if (keep_alive_) return read();
        stream_.socket().shutdown(Stream::socket::shutdown_send, error);
    }

    Shared& shared_;
    beast::basic_stream<Stream> stream_;
    beast::flat_buffer buffer_{64 * 1024};
    std::optional<http::request_parser<http::string_body>> parser_;
    std::weak_ptr<Work> work_;  // for the last request
    bool keep_alive_ = false;
    bool is_sending_ = false;  // a part of a streamed body
};

void accept(Acceptor& acceptor, Shared& shared) {
    acceptor.async_accept([&](error_code error, Stream::socket socket) {
        if (error == asio::error::operation_aborted) return;
        if (!error && shared.connections < shared.limits.connections)
            std::make_shared<Connection>(std::move(socket), shared)->read();
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
    Implementation(const Address& address, const Limits& limits) : shared{limits}, socket_path(address.unix_socket) {
        if (!socket_path.empty()) {
            acceptor.emplace(listen_at(shared.io, socket_path));
            return;
        }
        tcp::acceptor listening = listen_at(shared.io, address);
        port = listening.local_endpoint().port();
        acceptor.emplace(std::move(listening));
    }
    ~Implementation() {
        std::error_code ignored;
        if (!socket_path.empty()) std::filesystem::remove(socket_path, ignored);
    }
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;

    void serve(const Handler& handler, const std::stop_token& stop) {
        shared.handler = &handler;
        accept(*acceptor, shared);
        const std::stop_callback end(stop, [&] {
            shared.stop.request_stop();
            shared.io.stop();
        });
        shared.io.run();
        shared.pool.join();
    }

    Shared shared;
    std::filesystem::path socket_path;  // empty: TCP
    std::optional<Acceptor> acceptor;
    std::uint16_t port = 0;
};

Server::Server(const Address& address, const Limits& limits) : implementation_(new Implementation(address, limits)) {}

Server::~Server() = default;

std::uint16_t Server::port() const {
    return implementation_->port;
}

void Server::serve(const Handler& handler, const std::stop_token& stop) {
    implementation_->serve(handler, stop);
}

bool is_loopback(const std::string& host) {
    error_code error;
    const auto address = asio::ip::make_address(host, error);
    return !error && address.is_loopback();
}

}  // namespace stridor::explorer
