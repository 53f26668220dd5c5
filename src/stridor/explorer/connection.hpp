#pragma once

// One client's connection. Private to server.cpp, the only source with Boost: it takes long to compile.

#include "stridor/explorer/making.hpp"

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <poll.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace stridor::explorer {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using boost::system::error_code;
using Stream = asio::generic::stream_protocol;  // TCP or a socket in the file system: one copy of all that follows

/// Returns a view of the library as text.
inline std::string text(beast::string_view view) {
    return {view.data(), view.size()};
}

/// Returns the parts of a request that answers need.
inline HttpRequest request_of(http::request<http::string_body>&& message) {
    HttpRequest request;
    request.method = text(message.method_string());
    const std::string target = text(message.target());
    const std::size_t mark = target.find('?');
    request.path = target.substr(0, mark);
    if (mark != std::string::npos) request.query = target.substr(mark + 1);
    request.host = text(message[http::field::host]);
    request.origin = text(message[http::field::origin]);
    request.fetch_site = text(message["Sec-Fetch-Site"]);
    request.content_type = text(message[http::field::content_type]);
    // a second Host or Origin would leave it to chance which one is looked at
    for (const auto name : {http::field::host, http::field::origin})
        if (message.count(name) > 1) request.host.clear();
    request.body = std::move(message.body());
    return request;
}

/// Limits the number of header lines, each of which needs memory of its own, and allows only one way to send a body in
/// pieces: a proxy before this server may read another way differently.
class Parser : public http::request_parser<http::string_body> {
public:
    explicit Parser(const Limits& limits) : most_(limits.header_lines) {
        header_limit(static_cast<std::uint32_t>(limits.header));
        body_limit(limits.body);
    }

    /// Hands over the cookies of all servers on this host: many, and long. They are gone afterwards.
    std::string take_cookies() { return std::move(cookies_); }

private:
    void on_field_impl(http::field field, beast::string_view name, beast::string_view value,
                       error_code& error) override {
        constexpr std::size_t longest = 16 * 1024;  // [B] of what is no cookie; Beast itself holds 64 KiB
        if (field == http::field::cookie)
            cookies_ += (cookies_.empty() ? "" : "; ") + text(value);
        else if (++lines_ > most_ || value.size() > longest || name.size() > longest)
            error = http::error::header_limit;
        else if (field == http::field::transfer_encoding && (has_encoding_ || !beast::iequals(value, "chunked")))
            error = http::error::bad_transfer_encoding;
        else
            get().insert(field, name, value);
        has_encoding_ = has_encoding_ || field == http::field::transfer_encoding;
    }

    std::size_t most_;
    std::size_t lines_ = 0;
    bool has_encoding_ = false;
    std::string cookies_;
};

/// One client: reads a request, has it answered, sends the answer, and so on.
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
        place_ = shared_.strangers.insert(shared_.strangers.end(), this);
    }
    ~Connection() { leave(); }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /// Closes the connection to make room for another client.
    void close() { drop(); }

    /// Reads the next request. Its first byte may take its time, the rest may not.
    void read() {
        parser_.emplace(shared_.limits);
        if (buffer_.size() > 0) return receive();
        buffer_.shrink_to_fit();  // a large header is no reason to keep as much for the next
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
        HttpRequest request = request_of(parser_->release());
        request.cookie = parser_->take_cookies();
        if (auto refusal = refused(request)) return send(std::move(*refusal));
        meet();
        if (shared_.requests >= shared_.limits.requests) return send(plain(503, "Busy; try again in a moment."));
        is_streaming_ = false;
        const auto work = std::make_shared<Answering>(shared_.io, shared_.stop.get_token());
        work_ = work;
        work->deadline.expires_after(shared_.limits.working);
        work->deadline.async_wait(own([this, work](error_code error) {
            if (!error) lose(work);
        }));
        watch(work);
        shared_.add(work, own([this, work, request = std::move(request)] { make(request, work); }));
    }

    std::optional<Response> refused(const HttpRequest& request) const {
        try {
            return shared_.admit ? shared_.admit(request) : std::nullopt;
        } catch (...) {
            return plain(500, "The explorer failed to answer; its terminal may say more.");
        }
    }

    // a request was let through: this is the owner's, and no stranger's any more
    void meet() {
        if (place_) shared_.strangers.erase(*place_);
        place_.reset();
    }

    // it counts no more: its socket is closed, whoever still makes an answer for it
    void leave() {
        meet();
        if (std::exchange(is_counted_, false)) --shared_.connections;
    }

    // looks now and then whether the client has closed its end, whatever it sent before
    void watch(const std::shared_ptr<Answering>& work) {
        constexpr std::chrono::milliseconds interval{100};
        work->look.expires_after(interval);
        work->look.async_wait(own([this, work](error_code error) {
            if (error) return;
            pollfd socket{stream_.socket().native_handle(), POLLRDHUP, 0};
            const bool has_left = ::poll(&socket, 1, 0) > 0;
            has_left ? lose(work) : watch(work);
        }));
    }

    // nobody will read what is being made, or it takes too long
    void lose(const std::shared_ptr<Answering>& work) {
        if (work == nullptr) return;
        shared_.stop_work(work, own([this] {
                              keep_alive_ = false;
                              if (is_streaming_) return drop();
                              const bool is_stuck = shared_.given_up >= shared_.limits.given_up;
                              send(plain(503, is_stuck ? "Some runs do not stop. End stridor in its terminal (Ctrl-C)."
                                                       : "The answer took too long."));
                          }));
    }

    void drop() {
        stream_.close();
        leave();
    }

    // on a thread of its own
    void make(const HttpRequest& request, const std::shared_ptr<Answering>& work) {
        Response response = plain(500, "The explorer failed to answer; its terminal may say more.");
        try {
            response = shared_.handler(request, work->token());
        } catch (...) {
        }
        const auto stream = std::exchange(response.stream, nullptr);
        if (!stream)
            return asio::post(shared_.io, own([this, work, response = std::move(response)]() mutable {
                                  if (finish(*work)) send(std::move(response));
                              }));
        const auto parts = std::make_shared<Parts>();
        asio::post(shared_.io, own([this, work, parts, response = std::move(response)] {
                       if (work->state == Answering::State::making) begin(response, parts);
                   }));
        bool is_whole = true;
        try {
            stream(
                [&](std::string part) {
                    parts->push(std::move(part), work->token());
                    asio::post(shared_.io, own([this, work, parts] {
                                   if (work->state == Answering::State::making) send_next(parts);
                               }));
                },
                work->token());
        } catch (...) {
            is_whole = false;
        }
        if (work->token().stop_requested()) is_whole = false;
        asio::post(shared_.io, own([this, work, parts, is_whole] {
                       if (!finish(*work)) return;
                       // a client takes a body without its last chunk as cut off
                       if (!is_whole) return stream_.close();
                       parts->end();
                       send_next(parts);
                   }));
    }

    // false for one that was given up: its client has its answer, or is gone
    bool finish(Answering& work) {
        const bool is_wanted = work.state == Answering::State::making;
        shared_.finish(work);
        return is_wanted;
    }

    template <typename Body>
    void put_fields(http::response<Body>& message, const Response& response) {
        message.result(static_cast<unsigned>(response.status));
        message.version(11);
        message.keep_alive(keep_alive_);
        for (const auto& [name, value] : shared_.headers)
            message.set(name, value);
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
        is_streaming_ = true;
        stream_.expires_after(shared_.limits.sending);
        http::async_write_header(stream_, *header, own([this, message, header, parts](error_code error, std::size_t) {
                                     is_sending_ = false;
                                     error ? lose(work_.lock()) : send_next(parts);
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
                                  if (error) return lose(work_.lock());
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
        if (!error && keep_alive_) return read();
        if (!error) stream_.socket().shutdown(Stream::socket::shutdown_send, error);
        // whoever still makes an answer that nobody waits for keeps this object
        if (const auto work = work_.lock(); work && work->state == Answering::State::given_up) drop();
    }

    Shared& shared_;
    beast::basic_stream<Stream> stream_;
    beast::flat_buffer buffer_{shared_.limits.header + std::size_t{64} * 1024};
    std::optional<Parser> parser_;
    std::weak_ptr<Answering> work_;                          // for the last request
    std::optional<std::list<Connection*>::iterator> place_;  // among the strangers
    bool is_counted_ = true;
    bool keep_alive_ = false;
    bool is_sending_ = false;    // a part of a streamed body
    bool is_streaming_ = false;  // the answer's header is under way
};

}  // namespace stridor::explorer
