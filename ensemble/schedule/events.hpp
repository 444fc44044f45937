#pragma once
// What happens to a campaign in progress (events) and what is to be done about it (commands). A worker is a rank; it
// is known by its number. An attempt is one execution of a member, numbered from 1, so that a late answer is
// recognised.

#include <variant>

namespace floes {

/// A member still to be computed.
struct MemberTask {
    int number = 0;         ///< of the member, >= 0, unique
    double cost = 0;        ///< expected run time in any unit, > 0
    int batch = 0;          ///< all of an earlier batch is handed out before any of a later one
    int attempts_made = 0;  ///< in earlier runs; the next attempt is this + 1
    int failures = 0;       ///< of these, those that ended as failed
    bool suspect = false;   ///< its process was lost during an attempt: from now on it is computed apart
};

// -- events

/// A worker is ready for members: it computes `cores` at a time, and holds up to `prefetch` more so that no core waits
/// for a round trip; of short members, several times as many.
struct WorkerJoined {
    int worker = 0;
    int cores = 1;
    int prefetch = 0;
};

enum class AttemptEnd { done, failed };

/// The answer to an assignment has arrived.
struct MemberFinished {
    int worker = 0;
    int number = 0;
    int attempt = 0;
    AttemptEnd end = AttemptEnd::done;
    double run_time = 0;  ///< s that a done one took
};

/// A worker said farewell. What it held is to be done again.
struct WorkerLeft {
    int worker = 0;
};

/// A worker is gone without a word. What it held is to be done again, and one of that may have been the cause.
struct WorkerLost {
    int worker = 0;
};

/// The user or the batch system wants the run to end: nothing new is handed out.
struct StopRequested {};

/// What begins now must not cost more than this to be done in time.
struct TimeLeft {
    double cost = 0;
};

using Event = std::variant<WorkerJoined, MemberFinished, WorkerLeft, WorkerLost, StopRequested, TimeLeft>;

// -- commands

/// Give the member to the worker.
struct Assign {
    int worker = 0;
    int number = 0;
    int attempt = 0;
    bool apart = false;  ///< in a process of its own, whatever the others do
    friend bool operator==(const Assign&, const Assign&) = default;
};

/// Keep the answer of this attempt, the first valid one of its member or its last allowed failure. A late answer gets
/// no such command.
struct Record {
    int number = 0;
    int attempt = 0;
    friend bool operator==(const Record&, const Record&) = default;
};

/// The attempt failed, and is not the last one: remember why.
struct Retry {
    int number = 0;
    int attempt = 0;
    friend bool operator==(const Retry&, const Retry&) = default;
};

/// Tell the worker to abandon what it holds and say farewell; nothing more will come. Once a worker.
struct Dismiss {
    int worker = 0;
    friend bool operator==(const Dismiss&, const Dismiss&) = default;
};

using Command = std::variant<Assign, Record, Retry, Dismiss>;

}  // namespace floes
