#pragma once
// Members that end in every possible way, chosen by the member's number.

#include <sys/prctl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <stop_token>
#include <thread>
#include <vector>

#include "campaign/campaign.hpp"
#include "member/result.hpp"

namespace floes::members {

enum Way { good, crash, abort, hang, stop_itself, eat_memory, nan, exception, leave, killed, waits_for_stop };

inline Campaign campaign() {
    Campaign made;
    made.name = "ways";
    made.arrangements = 20;
    made.cases.push_back({"one", {}});
    return made;
}

inline MemberResult good_result() {
    MemberResult result;
    result.load.mean = 0.1;
    result.load.segment_maximum = {1.0 / 3, 2.0 / 3};
    result.averaged = {{.time = 0.5, .segment_maximum = {1, 2}, .peaks = {3}}};
    constexpr std::size_t bins = LoadMap::heights * LoadMap::angles;
    result.load_map = {std::vector(bins, 1.0 / 11), std::vector(bins, 1.0 / 12), std::vector(LoadMap::parts, 1.0 / 13)};
    result.history.surge.assign(100'000, 1.0 / 7);  // more than a socket holds
    return result;
}

inline void eat() {
    std::vector<std::vector<char>> eaten;
    while (true) eaten.emplace_back(1 << 20, 'x');
}

inline MemberResult compute(const Campaign&, int number, std::stop_token stop) {
    switch (static_cast<Way>(number)) {
        case crash:
            ::raise(SIGSEGV);
            break;
        case abort:
            std::abort();
        case hang:
            while (true) ::pause();
        case stop_itself:
            ::raise(SIGSTOP);
            break;
        case eat_memory:
            eat();
            break;
        case nan: {
            MemberResult result = good_result();
            result.load.mean = std::numeric_limits<double>::quiet_NaN();
            return result;
        }
        case exception:
            throw std::runtime_error("the ice melted");
        case leave:
            ::_exit(3);
        case killed:
            ::raise(SIGKILL);
            break;
        case waits_for_stop:
            while (!stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            throw std::runtime_error("stopped");
        case good:
            break;
    }
    return good_result();
}

}  // namespace floes::members
