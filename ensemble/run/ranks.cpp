#include "run/ranks.hpp"

#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include <fmt/format.h>

#include "campaign/write.hpp"
#include "core/error.hpp"
#include "run/worker.hpp"

namespace floes {

namespace {

using Clock = std::chrono::steady_clock;

// A process by descriptor, because its number may be reused before it is needed. (The wrappers of glibc 2.36 have no
// C++ linkage.)
Descriptor open_process(int pid) {
    return Descriptor(static_cast<int>(::syscall(SYS_pidfd_open, pid, 0)));
}

void kill_process(const Descriptor& process) {
    ::syscall(SYS_pidfd_send_signal, process.get(), SIGKILL, nullptr, 0);
}

Post post_of(int rank, const Groups& groups, const std::filesystem::path& journal) {
    const int writer = groups.writer_of(rank);
    if (writer != rank) return {writer, ""};
    return {writer, std::filesystem::absolute(piece_path(journal, groups.piece_of(rank))).string()};
}

void check_hello(int from, const Hello& hello, const std::string& fingerprint) {
    if (hello.fingerprint != fingerprint) {
        throw RunError(
            fmt::format("Rank {} on {} read a different campaign than the master ({} instead of {}): the "
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

Muster muster(Link& link, const Campaign& campaign, const Groups& groups, const std::filesystem::path& journal,
              const Hello& own, const SilenceLimits& patience) {
    Muster result{std::vector<Hello>(static_cast<std::size_t>(link.size())), false};
    result.hellos[0] = own;
    const Bytes text = link.size() > 1 ? encode_text(write_campaign(campaign)) : Bytes{};
    const bool has_writers = !groups.writers().empty();
    for (int rank = 1; rank < link.size(); ++rank) {
        if (has_writers) link.send(rank, Tag::post, encode(post_of(rank, groups, journal)));
        link.send(rank, Tag::campaign, text);
    }
    Pause pause = pause_between_polls(link.size());
    // Ranks begin at different speeds, so they have twice the time that is allowed to them later.
    const std::chrono::duration<double> longest_silence{2 * patience.with_a_worker};
    auto last_word = Clock::now();
    for (int present = 1; present < link.size();) {
        const auto message = link.poll();
        if (!message) {
            if (Clock::now() - last_word > longest_silence) {
                throw RunError(fmt::format("Only {} of {} ranks have answered after {:g} s of silence.", present,
                                           link.size(), longest_silence.count()));
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
        if (message->tag == Tag::alive) continue;  // it has said hello, and waits for slower ones
        if (message->tag != Tag::hello) throw RunError(fmt::format("Rank {} did not begin with hello.", message->from));
        const Hello hello = decode_hello(message->bytes);
        check_hello(message->from, hello, own.fingerprint);
        result.hellos[static_cast<std::size_t>(message->from)] = hello;
        ++present;
    }
    return result;
}

RankWatch::RankWatch(Link& link, const Muster& mustered, const SilenceLimits& patience, Time now)
    : link_(link), patience_(patience), silence_(link.size(), now) {
    const std::string& here = mustered.hellos.at(master_rank).host;
    for (int rank = 1; rank < link.size(); ++rank) {
        const Hello& hello = mustered.hellos.at(static_cast<std::size_t>(rank));
        if (hello.host == here) processes_.emplace(rank, open_process(hello.pid));
    }
}

std::vector<RankWatch::Lost> RankWatch::watch(Time now) {
    silence_.listened(now);
    if (silence_.total() < next_sign_) return {};
    next_sign_ = silence_.total() + patience_.sign_of_life;
    std::vector<Lost> newly_lost;
    for (int rank = 1; rank < link_.size(); ++rank) {
        if (lost_.contains(rank)) continue;
        link_.send(rank, Tag::alive, {});
        if (silence_.of(rank) < patience_.with_a_worker) continue;
        lost_.insert(rank);
        link_.abandon(rank);
        newly_lost.push_back({rank, silence_.of(rank)});
    }
    return newly_lost;
}

void RankWatch::part() {
    if (lost_.empty()) return;
    for (const int rank : lost_) {
        if (const auto found = processes_.find(rank); found != processes_.end()) kill_process(found->second);
    }
    for (int rank = 1; rank < link_.size(); ++rank) link_.send(rank, Tag::part, {});
}

}  // namespace floes
