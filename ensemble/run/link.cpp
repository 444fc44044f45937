// The only door to MPI.

#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1

#include "run/link.hpp"

#include <mpi.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstring>
#include <exception>
#include <functional>
#include <iterator>
#include <list>
#include <set>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/trial.hpp"

namespace floes {

namespace {

int cores_on_line() {
    return std::max(1, static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN)));
}

}  // namespace

int count_cores(const CoreMask& mask) {
    int count = 0;
    for (const std::uint64_t word : mask) count += std::popcount(word);
    return count;
}

CoreMask affinity_of_this_process() {
    CoreMask mask{};
    cpu_set_t set;
    CPU_ZERO(&set);
    if (::sched_getaffinity(0, sizeof set, &set) == 0) {
        static_assert(sizeof set == sizeof mask);
        std::memcpy(mask.data(), &set, sizeof mask);
        return mask;
    }
    const int cores = std::min<int>(cores_on_line(), 64 * static_cast<int>(mask.size()));
    for (int core = 0; core < cores; ++core)
        mask[static_cast<std::size_t>(core / 64)] |= std::uint64_t{1} << (core % 64);
    return mask;
}

int share_of_cores(std::span<const CoreMask> masks, std::size_t mine) {
    const int cores = count_cores(masks[mine]);
    const auto before = masks.first(mine);
    const int sharers = static_cast<int>(std::count(masks.begin(), masks.end(), masks[mine]));
    const int place = static_cast<int>(std::count(before.begin(), before.end(), masks[mine]));
    return std::max(1, cores / sharers + (place < cores % sharers ? 1 : 0));
}

Topology make_topology(std::span<const CoreMask> masks, std::size_t mine) {
    const int bound = count_cores(masks[mine]);
    CoreMask together{};
    for (const CoreMask& mask : masks) std::ranges::transform(together, mask, together.begin(), std::bit_or{});
    return {share_of_cores(masks, mine), bound, std::max(bound, cores_on_line()), static_cast<int>(masks.size()),
            count_cores(together)};
}

std::string binding_remark(const Topology& topology) {
    if (topology.node_ranks > topology.rank_cores)
        return fmt::format(
            "{} ranks on this node have {} between them, and each computes a member at a time; start no more ranks "
            "than "
            "cores, or, if mpirun bound them, --bind-to none lets them use all",
            topology.node_ranks, counted(topology.rank_cores, "core"));
    if (topology.node_ranks > 1 || topology.bound_cores >= topology.node_cores) return {};
    return fmt::format(
        "the only rank on this node is bound to {} of its {} cores; mpirun --bind-to none lets it use all",
        topology.bound_cores, topology.node_cores);
}

LocalLink::LocalLink() : topology_(make_topology(std::array<CoreMask, 1>{affinity_of_this_process()}, 0)) {}

void LocalLink::send(int to, Tag tag, std::vector<std::byte> bytes) {
    if (to != 0) throw RunError(fmt::format("There is no rank {}: this process is alone.", to));
    waiting_.push_back({0, tag, std::move(bytes)});
}

std::optional<Message> LocalLink::poll() {
    if (waiting_.empty()) return std::nullopt;
    Message message = std::move(waiting_.front());
    waiting_.pop_front();
    return message;
}

namespace {

constexpr std::size_t most_receives_at_once = 256;  // bounds the master's memory if many ranks answer at once
constexpr std::chrono::seconds longest_parting{10};
constexpr unsigned longest_finalize = 150;  // s, longer than the command of --on-end may take

/// Throws naming the call that failed.
void check(int code, const char* call) {
    if (code == MPI_SUCCESS) return;
    char text[MPI_MAX_ERROR_STRING] = "";
    int length = 0;
    MPI_Error_string(code, text, &length);
    throw RunError(fmt::format("MPI failed in {}: {}.", call, text));
}

#define FLOES_MPI(call) check(call, #call)

// Open MPI catches crashes to print a stack trace, which allocates memory. After a crash inside malloc the handler
// deadlocks, and the whole run with it. So the signal handlers from before MPI are restored.
class CrashSignals {
  public:
    CrashSignals() {
        for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], nullptr, &former_[i]);
    }
    ~CrashSignals() {
        for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &former_[i], nullptr);
    }
    CrashSignals(const CrashSignals&) = delete;
    CrashSignals& operator=(const CrashSignals&) = delete;

  private:
    static constexpr std::array signals{SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV};
    std::array<struct sigaction, signals.size()> former_{};
};

// MPI starts together. If a rank dies meanwhile and mpirun lets the others go on (--enable-recovery), they wait for it
// forever.
class StartDeadline {
  public:
    explicit StartDeadline(unsigned seconds) {
        struct sigaction action {};
        action.sa_handler = [](int) {
            constexpr std::string_view text =
                "floes: MPI did not start in time; another rank was lost while it did. Start the run again, with "
                "--resume.\n";
            [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
            ::_exit(1);
        };
        ::sigaction(SIGALRM, &action, &former_);
        ::alarm(seconds);
    }
    ~StartDeadline() {
        ::alarm(0);
        ::sigaction(SIGALRM, &former_, nullptr);
    }
    StartDeadline(const StartDeadline&) = delete;
    StartDeadline& operator=(const StartDeadline&) = delete;

  private:
    struct sigaction former_ {};
};

std::vector<CoreMask> masks_of(MPI_Comm node) {
    int ranks = 0;
    FLOES_MPI(MPI_Comm_size(node, &ranks));
    const CoreMask own = affinity_of_this_process();
    std::vector<CoreMask> masks(static_cast<std::size_t>(ranks));
    FLOES_MPI(MPI_Allgather(own.data(), sizeof own, MPI_BYTE, masks.data(), sizeof own, MPI_BYTE, node));
    return masks;
}

Topology find_topology() {
    MPI_Comm node = MPI_COMM_NULL;
    FLOES_MPI(MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node));
    int place = 0;
    FLOES_MPI(MPI_Comm_rank(node, &place));
    const Topology topology = make_topology(masks_of(node), static_cast<std::size_t>(place));
    FLOES_MPI(MPI_Comm_free(&node));
    return topology;
}

class MpiLink final : public Link {
  public:
    explicit MpiLink(unsigned longest_start) : exceptions_(std::uncaught_exceptions()) {
        const StartDeadline deadline(longest_start);
        int provided = MPI_THREAD_SINGLE;
        {
            const CrashSignals former;
            FLOES_MPI(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided));
        }
        if (provided < MPI_THREAD_FUNNELED) {
            throw RunError(
                "This MPI library does not let a rank have threads (MPI_THREAD_FUNNELED); floes needs that.");
        }
        FLOES_MPI(MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN));
        FLOES_MPI(MPI_Comm_rank(MPI_COMM_WORLD, &rank_));
        FLOES_MPI(MPI_Comm_size(MPI_COMM_WORLD, &size_));
        topology_ = find_topology();
    }

    /// Waits (asleep, for a limited time) until all messages are sent, then ends MPI. During an exception MPI_Finalize
    /// is not called, because the other ranks may never reach it: mpirun then sees an improper exit and ends them all,
    /// instead of waiting without end. It is not called either if a rank was abandoned. If a rank hangs in it for
    /// minutes, SIGALRM ends this process.
    ~MpiLink() override {
        if (std::uncaught_exceptions() > exceptions_) return;
        const auto deadline = std::chrono::steady_clock::now() + longest_parting;
        try {
            while (!outgoing_.empty() && std::chrono::steady_clock::now() < deadline) {
                forget_sent();
                std::this_thread::sleep_for(std::chrono::microseconds(200));
            }
        } catch (const RunError&) {
            return;  // MPI itself failed: MPI_Finalize would hang
        }
        if (!outgoing_.empty() || !abandoned_.empty()) return;
        // MPI_Finalize waits for every rank, and one may be suspended. All results are sent and stored, so SIGALRM may
        // end it.
        ::alarm(longest_finalize);
        MPI_Finalize();
        ::alarm(0);
    }

    int rank() const override { return rank_; }
    int size() const override { return size_; }
    const Topology& topology() const override { return topology_; }

    void send(int to, Tag tag, std::vector<std::byte> bytes) override {
        if (bytes.size() > INT_MAX)
            throw RunError(fmt::format("A message of {} bytes is too long for MPI.", bytes.size()));
        if (abandoned_.contains(to)) return;
        Transfer& transfer = outgoing_.emplace_back(Transfer{{to, tag, std::move(bytes)}, MPI_REQUEST_NULL});
        const auto& payload = transfer.message.bytes;
        FLOES_MPI(MPI_Isend(payload.data(), static_cast<int>(payload.size()), MPI_BYTE, to, static_cast<int>(tag),
                            MPI_COMM_WORLD, &transfer.request));
    }

    std::optional<Message> poll() override {
        forget_sent();
        begin_receiving();
        return take_arrived();
    }

    void abandon(int rank) override {
        abandoned_.insert(rank);
        // A transfer to that rank may never complete, and its buffer belongs to MPI until it does.
        std::list<Transfer>::iterator next;
        for (auto it = outgoing_.begin(); it != outgoing_.end(); it = next) {
            next = std::next(it);
            if (it->message.from == rank) stranded_.splice(stranded_.end(), outgoing_, it);
        }
    }

    bool moving() const override { return !outgoing_.empty() || !incoming_.empty(); }

  private:
    struct Transfer {
        Message message;  // `from` is the other rank, in both directions
        MPI_Request request = MPI_REQUEST_NULL;

        bool complete() {
            int done = 0;
            FLOES_MPI(MPI_Test(&request, &done, MPI_STATUS_IGNORE));
            return done != 0;
        }
    };

    void forget_sent() {
        std::erase_if(outgoing_, [](Transfer& transfer) { return transfer.complete(); });
    }

    void begin_receiving() {
        while (incoming_.size() < most_receives_at_once) {
            int found = 0;
            MPI_Message matched = MPI_MESSAGE_NULL;
            MPI_Status status;
            FLOES_MPI(MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &found, &matched, &status));
            if (found == 0) return;
            int size = 0;
            FLOES_MPI(MPI_Get_count(&status, MPI_BYTE, &size));
            Transfer& transfer = incoming_.emplace_back(
                Transfer{{status.MPI_SOURCE, static_cast<Tag>(status.MPI_TAG), {}}, MPI_REQUEST_NULL});
            transfer.message.bytes.resize(static_cast<std::size_t>(size));
            FLOES_MPI(MPI_Imrecv(transfer.message.bytes.data(), size, MPI_BYTE, &matched, &transfer.request));
        }
    }

    std::optional<Message> take_arrived() {
        std::set<int> waiting_for;  // a message never overtakes an earlier one of its sender
        for (auto it = incoming_.begin(); it != incoming_.end(); ++it) {
            const int from = it->message.from;
            if (waiting_for.contains(from)) continue;
            if (!it->complete()) {
                waiting_for.insert(from);
                continue;
            }
            Message message = std::move(it->message);
            incoming_.erase(it);
            return message;
        }
        return std::nullopt;
    }

    int rank_ = 0;
    int size_ = 1;
    int exceptions_ = 0;  // active at construction
    Topology topology_;
    std::set<int> abandoned_;
    std::list<Transfer> outgoing_;
    std::list<Transfer> stranded_;  // sent to ranks that were abandoned later
    std::list<Transfer> incoming_;  // in the order in which they were matched
};

}  // namespace

std::string library_version() {
    char text[MPI_MAX_LIBRARY_VERSION_STRING] = "";
    int length = 0;
    MPI_Get_library_version(text, &length);
    const std::string version(text);
    return version.substr(0, version.find_first_of(",\n"));
}

std::unique_ptr<Link> open_link(unsigned longest_start) {
    if (started_by_mpi()) return std::make_unique<MpiLink>(longest_start);
    return std::make_unique<LocalLink>();
}

}  // namespace floes
