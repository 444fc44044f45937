#include "serve/http_server.hpp"

#include <cstdint>
#include <future>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>

#include "core/error.hpp"

namespace floes {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using boost::asio::ip::tcp;
using boost::system::error_code;

class Connection;

/// What a connection wants of the server that it belongs to.
struct Keeper {
    HttpLimits limits;
    HttpServer::Handler handler;
    std::function<void(const std::shared_ptr<Connection>&)> gone;
    bool ending = false;
};

using Context = std::shared_ptr<asio::io_context>;

std::string text_of(beast::string_view text) {
    return {text.data(), text.size()};
}

HttpReply refusal(http::status status, ModelError::Kind kind, const std::string& sentence) {
    HttpReply refused = reply(ModelError(kind, sentence));
    refused.status = static_cast<int>(status);
    return refused;
}

/// The reply to bytes that are no request; none where the other end went away.
std::optional<HttpReply> reply_to(const error_code& error, const HttpLimits& limits) {
    constexpr auto kind = ModelError::Kind::invalid_input;
    if (error == http::error::body_limit)
        return refusal(http::status::payload_too_large, kind,
                       fmt::format("The request is longer than {} bytes, the most that are read", limits.body));
    if (error == http::error::header_limit)
        return refusal(
            http::status::request_header_fields_too_large, kind,
            fmt::format("The headers of the request are longer than {} bytes, the most that are read", limits.header));
    const bool spoken = error.category() == make_error_code(http::error::end_of_stream).category();
    if (!spoken || error == http::error::end_of_stream || error == http::error::partial_message) return std::nullopt;
    return refusal(http::status::bad_request, kind, fmt::format("This is not HTTP: {}", error.message()));
}

/// Whether they are equal, in a time that depends on `given` alone: nobody finds the token letter by letter.
bool equals(std::string_view given, std::string_view token) {
    volatile unsigned differs = given.size() == token.size() ? 0 : 1;
    for (std::size_t i = 0; i < given.size(); ++i)
        differs = differs | static_cast<unsigned char>(given[i] ^ token[i % token.size()]);
    return differs == 0;
}

/// Why a request with this field is not answered; none where it bears the token.
std::optional<std::string> refusal_of(std::string_view authorization, const std::string& token) {
    constexpr std::string_view scheme = "Bearer ";
    if (token.empty()) return std::nullopt;
    const std::string_view begin = authorization.substr(0, scheme.size());
    if (!beast::iequals({begin.data(), begin.size()}, {scheme.data(), scheme.size()}))
        return "This server asks for a token; send it in a header, Authorization: Bearer TOKEN";
    if (!equals(authorization.substr(scheme.size()), token)) return "The token is not that of this server";
    return std::nullopt;
}

/// One connection: a request, its reply, the next request. All in the server's thread; the listener owns it.
class Connection : public std::enable_shared_from_this<Connection> {
  public:
    Connection(const Context& context, tcp::socket socket, Keeper& keeper)
        : context_(context), stream_(std::move(socket)), keeper_(keeper) {}

    void read() {
        parser_.emplace();
        parser_->body_limit(keeper_.limits.body);
        parser_->header_limit(static_cast<std::uint32_t>(keeper_.limits.header));
        reading_ = true;
        stream_.expires_after(keeper_.limits.patience);
        http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](const error_code& error, std::size_t) {
            self->reading_ = false;
            self->take(error);
        });
    }

    /// The server ends: no further request is read. (A mere cancel() would miss a read between two of its parts.)
    void leave() {
        if (reading_) stream_.close();
    }

  private:
    void take(const error_code& error) {
        if (error) {
            const std::optional<HttpReply> fault = reply_to(error, keeper_.limits);
            return fault ? write(*fault, false) : end();
        }
        const auto request = parser_->release();
        head_ = request.method() == http::verb::head;
        if (request.count(http::field::origin) > 0)
            return write(refusal(http::status::forbidden, ModelError::Kind::unavailable,
                                 "Requests of web pages are not answered; ask from a program"),
                         false);
        const std::string authorization = text_of(request[http::field::authorization]);
        if (const auto refused = refusal_of(authorization, keeper_.limits.token))
            return write(refusal(http::status::unauthorized, ModelError::Kind::unavailable, *refused), false);
        stream_.expires_never();  // an answer takes as long as its simulations
        // Whoever answers late must not keep alive what belongs to a server that has ended.
        auto respond = [context = std::weak_ptr(context_), one = weak_from_this(),
                        keep = request.keep_alive()](const HttpReply& reply) {
            const Context still = context.lock();
            if (still == nullptr) return;
            asio::post(*still, [one, keep, reply] {
                if (const auto self = one.lock()) self->write(reply, keep);
            });
        };
        keeper_.handler({text_of(request.method_string()), text_of(request.target()), request.body()},
                        std::move(respond));
    }

    void write(const HttpReply& reply, bool keep) {
        constexpr unsigned version = 11;  // HTTP/1.1
        keep = keep && !keeper_.ending;
        response_.emplace(static_cast<http::status>(reply.status), version, reply.body + "\n");
        response_->set(http::field::content_type, "application/json");
        if (response_->result() == http::status::unauthorized) response_->set(http::field::www_authenticate, "Bearer");
        response_->keep_alive(keep);
        response_->prepare_payload();
        if (head_) response_->body().clear();
        stream_.expires_after(keeper_.limits.patience);
        http::async_write(stream_, *response_, [self = shared_from_this(), keep](const error_code& error, std::size_t) {
            if (error || self->keeper_.ending) return self->end();
            return keep ? self->read() : self->part();
        });
    }

    /// Closed at once, a connection with something unread would take the reply away from who has not read it yet.
    void part() {
        error_code ignored;
        stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
        buffer_.clear();
        stream_.expires_after(keeper_.limits.patience);
        drain(most_drained);
    }

    void drain(std::size_t left) {
        reading_ = true;
        stream_.async_read_some(buffer_.prepare(one_read),
                                [self = shared_from_this(), left](const error_code& error, std::size_t read) {
                                    self->reading_ = false;
                                    return error || read >= left ? self->end() : self->drain(left - read);
                                });
    }

    void end() {
        stream_.close();
        if (keeper_.gone) keeper_.gone(shared_from_this());
    }

    static constexpr std::size_t most_drained = 16 * 1024 * 1024;
    static constexpr std::size_t one_read = 64 * 1024;

    Context context_;
    beast::tcp_stream stream_;
    Keeper& keeper_;
    beast::flat_buffer buffer_;
    std::optional<http::request_parser<http::string_body>> parser_;
    std::optional<http::response<http::string_body>> response_;
    bool reading_ = false;
    bool head_ = false;
};

asio::ip::address address_of(const std::string& host) {
    error_code error;
    auto address =
        host == "localhost" ? asio::ip::address(asio::ip::address_v4::loopback()) : asio::ip::make_address(host, error);
    if (error)
        throw InputError(
            fmt::format("--host {} is no address; give a numeric one: 127.0.0.1 for this machine alone, 0.0.0.0 for "
                        "everybody who reaches it",
                        host));
    return address;
}

}  // namespace

bool is_loopback(const std::string& host) {
    return address_of(host).is_loopback();
}

/// Accepts connections as long as there are not too many. In the server's thread.
class HttpServer::Listener {
  public:
    Listener(Context context, const tcp::endpoint& at, Keeper& keeper)
        : context_(std::move(context)), acceptor_(*context_), pause_(*context_), keeper_(keeper) {
        try {
            acceptor_.open(at.protocol());
            acceptor_.set_option(asio::socket_base::reuse_address(true));
            acceptor_.bind(at);
            acceptor_.listen();
        } catch (const boost::system::system_error& error) {
            throw RunError(fmt::format("Port {} of {} cannot be listened at ({}); give another one by --port",
                                       at.port(), at.address().to_string(), error.code().message()));
        }
        keeper_.gone = [this](const std::shared_ptr<Connection>& one) {
            connections_.erase(one);
            accept();
        };
        accept();
    }
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;
    ~Listener() { keeper_.gone = nullptr; }

    tcp::endpoint where() const { return acceptor_.local_endpoint(); }

    void leave() {
        keeper_.ending = true;
        error_code ignored;
        acceptor_.close(ignored);
        pause_.cancel();
        for (const auto& one : connections_) one->leave();
    }

  private:
    void accept() {
        if (accepting_ || keeper_.ending || connections_.size() >= keeper_.limits.connections) return;
        accepting_ = true;
        acceptor_.async_accept([this](const error_code& error, tcp::socket socket) {
            accepting_ = false;
            if (keeper_.ending) return;
            if (error) return pause();
            const auto one = std::make_shared<Connection>(context_, std::move(socket), keeper_);
            connections_.insert(one);
            one->read();
            accept();
        });
    }

    /// There may be no descriptors left: then the next accept would fail at once as well.
    void pause() {
        accepting_ = true;
        pause_.expires_after(std::chrono::milliseconds(100));
        pause_.async_wait([this](const error_code& cancelled) {
            accepting_ = false;
            if (!cancelled) accept();
        });
    }

    Context context_;
    tcp::acceptor acceptor_;
    asio::steady_timer pause_;
    Keeper& keeper_;
    std::set<std::shared_ptr<Connection>> connections_;
    bool accepting_ = false;
};

struct HttpServer::Running {
    Running(const std::string& host, int port, const HttpLimits& limits, Handler handler)
        : keeper{limits, std::move(handler), {}},
          listener(context, {address_of(host), static_cast<unsigned short>(port)}, keeper),
          where(listener.where()),
          thread([this] {
              context->run();
              over.set_value();
          }) {}
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    /// Replies under way are let go, for a while.
    ~Running() {
        asio::post(*context, [this] {
            listener.leave();
            busy.reset();
        });
        if (ended.wait_for(keeper.limits.parting) != std::future_status::ready) context->stop();
    }

    Context context = std::make_shared<asio::io_context>(1);
    asio::executor_work_guard<asio::io_context::executor_type> busy{context->get_executor()};
    Keeper keeper;
    Listener listener;
    tcp::endpoint where;
    std::promise<void> over;
    std::future<void> ended = over.get_future();
    std::jthread thread;
};

HttpServer::HttpServer(const std::string& host, int port, const HttpLimits& limits, Handler handler)
    : running_(std::make_unique<Running>(host, port, limits, std::move(handler))) {}

HttpServer::~HttpServer() = default;

std::string HttpServer::address() const {
    const asio::ip::address host = running_->where.address();
    const std::string name = host.is_v6() ? fmt::format("[{}]", host.to_string()) : host.to_string();
    return fmt::format("http://{}:{}", name, running_->where.port());
}

}  // namespace floes
