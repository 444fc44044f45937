#pragma once
// Gathering the ranks before the first member is handed out.

#include <vector>

#include "driver/messages.hpp"
#include "wire/link.hpp"

namespace floes {

struct Muster {
    std::vector<Hello> hellos;    ///< by rank
    bool stop_requested = false;  ///< a rank got a signal meanwhile

    int cores() const;  ///< of all ranks
};

/// Sends the campaign to every other rank and waits until each has said hello. `own`: the master's own hello.
/// Throws RunError when a rank understood another campaign, is in trouble, or does not answer.
Muster muster(Link& link, const Campaign& campaign, const Hello& own);

}  // namespace floes
