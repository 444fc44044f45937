#pragma once
// HTTP over TCP: requests in, replies out. The door to Boost.Beast, which takes seconds to compile wherever it is
// included.

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "serve/um_bridge.hpp"

namespace floes {

struct HttpRequest {
    std::string method;
    std::string path;
    std::string body;
};

struct HttpLimits {
    std::size_t body = 64 * 1024;               ///< bytes of a request
    std::size_t header = 8 * 1024;              ///< bytes of what comes before
    std::size_t connections = 64;               ///< at a time; further ones wait until one ends
    std::chrono::milliseconds patience{30000};  ///< for a request to arrive and for a reply to leave
    std::chrono::milliseconds parting{3000};    ///< for replies under way when the server ends
    std::string token = {};                     ///< that every request must bear; empty: none
};

/// Whether only this machine reaches the numeric address `host`, or "localhost". Throws InputError for none.
bool is_loopback(const std::string& host);

/// Serves from its construction to its destruction, in a thread of its own.
class HttpServer {
  public:
    /// May be called once from any thread, then or later, also after the end of the server.
    using Respond = std::function<void(const HttpReply&)>;
    /// Called in the server's thread; returns soon.
    using Handler = std::function<void(const HttpRequest&, Respond)>;

    /// Listens at the numeric address `host`, or at the loopback address for "localhost"; port 0 is any free one. What
    /// HTTP itself does not allow is answered without the handler, in the form of reply(ModelError), and so are a
    /// request without the token (401), and one that a web page makes, which a browser would send without asking its
    /// user (403). Throws InputError for an address that is none, RunError if it cannot be listened at.
    HttpServer(const std::string& host, int port, const HttpLimits& limits, Handler handler);
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;
    ~HttpServer();

    /// "http://127.0.0.1:4242"
    std::string address() const;

  private:
    class Listener;
    struct Running;

    std::unique_ptr<Running> running_;
};

}  // namespace floes
