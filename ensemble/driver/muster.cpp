#include "driver/muster.hpp"

#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "campaign/write.hpp"
#include "core/error.hpp"
#include "driver/pause.hpp"

namespace floes {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds longest_silence{120};

void check_hello(int from, const Hello& hello, const std::string& fingerprint) {
    if (hello.fingerprint != fingerprint) {
        throw RunError(
            fmt::format("Rank {} on {} understood another campaign than the master ({} instead of {}): the "
                        "ranks run different builds of floes.",
                        from, hello.host, hello.fingerprint, fingerprint));
    }
}

}  // namespace

int Muster::cores() const {
    int sum = 0;
    for (const Hello& hello : hellos) sum += hello.cores;
    return sum;
}

Muster muster(Link& link, const Campaign& campaign, const Hello& own) {
    Muster result{std::vector<Hello>(static_cast<std::size_t>(link.size())), false};
    result.hellos[0] = own;
    const Bytes text = link.size() > 1 ? encode_text(write_campaign(campaign)) : Bytes{};
    for (int rank = 1; rank < link.size(); ++rank) link.send(rank, Tag::campaign, text);
    Pause pause = pause_between_polls(link.size());
    auto last_word = Clock::now();
    for (int present = 1; present < link.size();) {
        const auto message = link.poll();
        if (!message) {
            if (Clock::now() - last_word > longest_silence) {
                throw RunError(fmt::format("Only {} of {} ranks are there after {} s of silence.", present, link.size(),
                                           longest_silence.count()));
            }
            std::this_thread::sleep_for(pause.next());
            continue;
        }
        last_word = Clock::now();
        pause.something_happened();
        if (message->tag == Tag::trouble) {
            throw RunError(fmt::format("Rank {}: {}", message->from, decode_text(message->bytes)));
        }
        if (message->tag == Tag::stop_request) {
            result.stop_requested = true;
            continue;
        }
        if (message->tag != Tag::hello) throw RunError(fmt::format("Rank {} did not begin with hello.", message->from));
        const Hello hello = decode_hello(message->bytes);
        check_hello(message->from, hello, own.fingerprint);
        result.hellos[static_cast<std::size_t>(message->from)] = hello;
        ++present;
    }
    return result;
}

}  // namespace floes
