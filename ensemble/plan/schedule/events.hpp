#pragma once
// Events of a running campaign, and the commands that answer them. A worker is a rank, identified by its number. An
// attempt is one execution of a member, numbered from 1 so that a late answer is recognised.

#include <variant>

namespace floes {

/// A member still to be computed.
struct MemberTask {
    int number = 0;         ///< member number, >= 0, unique
    double cost = 0;        ///< expected run time in any unit, > 0
    int batch = 0;          ///< all members of a batch are handed out before any of a later batch
    int attempts_made = 0;  ///< in earlier runs; the next attempt is this + 1
    int failures = 0;       ///< those of these attempts that failed
    bool suspect = false;   ///< its process was lost during an attempt, so it is computed in an isolated process
};

// -- events

/// A worker is ready for members. It computes `cores` at a time and holds up to `prefetch` more (several times as many
/// short ones), so that no core waits for a round trip.
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
    double run_time = 0;  ///< s, if done
};

/// A worker said farewell. The members that it held are to be run again.
struct WorkerLeft {
    int worker = 0;
};

/// A worker was lost. The members that it held are to be run again, and one of them may be the cause.
struct WorkerLost {
    int worker = 0;
};

/// The user or the batch system wants the run to end: nothing new is handed out.
struct StopRequested {};

/// Only members up to this cost can finish in time if started now.
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
    bool apart = false;  ///< in an isolated process, even if the others are not
    friend bool operator==(const Assign&, const Assign&) = default;
};

/// Keep the answer of this attempt: the member's first valid answer or its last allowed failure. A late answer gets no
/// such command.
struct Keep {
    int number = 0;
    int attempt = 0;
    friend bool operator==(const Keep&, const Keep&) = default;
};

/// The attempt failed but was not the last one: remember the reason.
struct Retry {
    int number = 0;
    int attempt = 0;
    friend bool operator==(const Retry&, const Retry&) = default;
};

/// Tell the worker to abandon its members and say farewell; nothing more will come. Once for each worker.
struct Dismiss {
    int worker = 0;
    friend bool operator==(const Dismiss&, const Dismiss&) = default;
};

using Command = std::variant<Assign, Keep, Retry, Dismiss>;

}  // namespace floes
