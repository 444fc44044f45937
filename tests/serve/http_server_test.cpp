// What Python's end-to-end test (serve_test.py) cannot see: servers that end while somebody waits.

#include "serve/http_server.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <fmt/format.h>

#include <array>
#include <condition_variable>
#include <mutex>
#include <string>

#include "core/descriptor.hpp"
#include "core/error.hpp"

namespace floes {
namespace http_server_test {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// A connection that has sent `text`.
Descriptor sent(const HttpServer& server, const std::string& text) {
    const std::string address = server.address();
    Descriptor socket(::socket(AF_INET, SOCK_STREAM, 0));
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_port = htons(static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))));
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(socket.get(), reinterpret_cast<const sockaddr*>(&at), sizeof at) != 0) ADD_FAILURE() << "no server";
    EXPECT_EQ(::send(socket.get(), text.data(), text.size(), 0), std::ssize(text));
    return socket;
}

/// Everything until the other end closes.
std::string received(const Descriptor& socket) {
    std::string all;
    std::array<char, 4096> some{};
    for (ssize_t read = 1; read > 0;) {
        read = ::recv(socket.get(), some.data(), some.size(), 0);
        if (read > 0) all.append(some.data(), static_cast<std::size_t>(read));
    }
    return all;
}

const std::string request = "GET /a HTTP/1.1\r\nHost: here\r\n\r\n";

/// Holds the last request until somebody answers it.
class Held {
  public:
    HttpServer::Handler handler() {
        return [this](const HttpRequest& asked, HttpServer::Respond respond) {
            const std::scoped_lock lock(mutex_);
            path = asked.path;
            respond_ = std::move(respond);
            came_.notify_one();
        };
    }

    HttpServer::Respond wait() {
        std::unique_lock lock(mutex_);
        came_.wait(lock, [&] { return static_cast<bool>(respond_); });
        return respond_;
    }

    std::string path;

  private:
    std::mutex mutex_;
    std::condition_variable came_;
    HttpServer::Respond respond_;
};

TEST(HttpServer, AnswersLater) {
    Held held;
    const HttpServer server("127.0.0.1", 0, {}, held.handler());
    const Descriptor socket = sent(server, "GET /a HTTP/1.1\r\nConnection: close\r\n\r\n");
    held.wait()({200, "{}"});
    EXPECT_EQ(held.path, "/a");
    EXPECT_THAT(received(socket), HasSubstr("HTTP/1.1 200 OK\r\n"));
}

TEST(HttpServer, LetsRepliesGo) {
    Held held;
    auto server = std::make_unique<HttpServer>("127.0.0.1", 0, HttpLimits{}, held.handler());
    const Descriptor socket = sent(*server, request);
    held.wait()({503, "{\"over\": 1}"});
    server.reset();
    EXPECT_THAT(received(socket), HasSubstr("{\"over\": 1}"));
}

TEST(HttpServer, EndsWhileSomebodyWaits) {
    Held held;
    auto server = std::make_unique<HttpServer>("127.0.0.1", 0, HttpLimits{}, held.handler());
    const Descriptor waiting = sent(*server, request);
    const HttpServer::Respond late = held.wait();
    const Descriptor idle = sent(*server, "GET");
    server.reset();
    EXPECT_EQ(received(waiting), "");
    EXPECT_EQ(received(idle), "");
    late({200, "{}"});  // nobody is there
}

TEST(HttpServer, ClosesWhoSaysNothing) {
    Held held;
    HttpLimits limits;
    limits.patience = std::chrono::milliseconds(50);
    const HttpServer server("127.0.0.1", 0, limits, held.handler());
    EXPECT_EQ(received(sent(server, "GET /a HT")), "");
}

TEST(HttpServer, AnswersWhoBearsTheToken) {
    int answered = 0;
    HttpLimits limits;
    limits.token = "0123456789abcdef";
    const HttpServer server("127.0.0.1", 0, limits, [&](const HttpRequest&, const HttpServer::Respond& respond) {
        ++answered;
        respond({200, "{}"});
    });
    const auto reply_to = [&](const std::string& field) {
        return received(sent(server, "GET /a HTTP/1.1\r\nConnection: close\r\n" + field + "\r\n"));
    };
    EXPECT_THAT(reply_to("Authorization: Bearer 0123456789abcdef\r\n"), HasSubstr("HTTP/1.1 200 OK"));
    EXPECT_THAT(reply_to("authorization: bearer 0123456789abcdef\r\n"), HasSubstr("HTTP/1.1 200 OK"));
    EXPECT_EQ(answered, 2);
    for (const char* wrong : {"0123456789abcdeg", "1123456789abcdef", "0123456789abcde", "0123456789abcdef0",
                              "0123456789abcdef0123456789abcdef", ""}) {
        const std::string reply = reply_to(fmt::format("Authorization: Bearer {}\r\n", wrong));
        EXPECT_THAT(reply, HasSubstr("HTTP/1.1 401 Unauthorized")) << wrong;
        EXPECT_THAT(reply, HasSubstr("WWW-Authenticate: Bearer"));
        EXPECT_THAT(reply, testing::Not(HasSubstr("0123456789abcdef")));
    }
    EXPECT_THAT(reply_to("Authorization: Bearer 0123456789abcdeg\r\n"), HasSubstr("The token is not that of this"));
    EXPECT_THAT(reply_to(""), HasSubstr("This server asks for a token; send it in a header"));
    EXPECT_THAT(reply_to("Authorization: Basic 0123456789abcdef\r\n"), HasSubstr("HTTP/1.1 401"));
    EXPECT_EQ(answered, 2);
}

TEST(HttpServer, KnowsWhichAddressesOthersReach) {
    for (const char* host : {"127.0.0.1", "127.3.2.1", "localhost", "::1"}) EXPECT_TRUE(is_loopback(host)) << host;
    for (const char* host : {"0.0.0.0", "::", "192.168.1.2"}) EXPECT_FALSE(is_loopback(host)) << host;
}

TEST(HttpServer, RefusesAnAddressThatItCannotHave) {
    const HttpServer server("localhost", 0, {}, [](const HttpRequest&, const HttpServer::Respond&) {});
    EXPECT_THAT(server.address(), HasSubstr("http://127.0.0.1:"));
    const int taken = std::stoi(server.address().substr(server.address().rfind(':') + 1));
    EXPECT_THAT([&] { HttpServer("127.0.0.1", taken, {}, {}); },
                ThrowsMessage<RunError>(HasSubstr("cannot be listened at (Address already in use); give another one by "
                                                  "--port")));
    EXPECT_THAT([] { HttpServer("example.org", 0, {}, {}); },
                ThrowsMessage<InputError>(HasSubstr("--host example.org is no address; give a numeric one")));
}

}  // namespace http_server_test
}  // namespace floes
