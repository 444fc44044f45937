// A floes run with fake members that break in a chosen way, for the scripts beside it.
//
//     faulty FOLDER NAME.h5 ISOLATION THREADS[/WRITERS] [WAY MEMBER]
//     faulty FOLDER NAME.h5 ISOLATION THREADS[/WRITERS] members COUNT
//
// FOLDER gets the process numbers of every rank and its helper. With a WAY, the MEMBER breaks in this way on its first
// attempt, with the prefix "always_" on every attempt. "members": COUNT members, a multiple of three, that take no time
// and may be lost a hundred times. Resumes an existing campaign.

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "run/attempt.hpp"
#include "run/link.hpp"
#include "run/run_campaign.hpp"
#include "run/worker.hpp"
#include "support/synthetic.hpp"

namespace {

using namespace floes;

struct Fault {
    std::filesystem::path mark;  // is there when the member broke already
    std::string way;
    int member = -1;

    bool due() const {
        if (way.starts_with("always_")) return true;
        if (std::filesystem::exists(mark)) return false;
        std::ofstream(mark) << way;
        return true;
    }
};

void break_down(const std::string& way, MemberResult& result) {
    if (way.ends_with("segv")) ::raise(SIGSEGV);
    if (way.ends_with("abort")) std::abort();
    if (way.ends_with("kill")) ::raise(SIGKILL);
    if (way.ends_with("stop")) ::raise(SIGSTOP);
    if (way.ends_with("hang")) {
        while (true) ::pause();
    }
    if (way.ends_with("memory")) {
        for (std::vector<std::vector<char>> eaten; true;) eaten.emplace_back(1 << 20, 'x');
    }
    if (way.ends_with("nan")) result.load.mean = std::numeric_limits<double>::quiet_NaN();
    if (way.ends_with("throw")) throw std::runtime_error("the ice melted");
}

MemberFunction computing(const Fault& fault, bool at_once) {
    return [=](const Campaign& campaign, int number, const std::stop_token&) {
        if (!at_once) std::this_thread::sleep_for(std::chrono::milliseconds(10 + 7 * (number % 5)));
        MemberResult result = synthetic::record(campaign, number).result;
        if (number == fault.member && fault.due()) break_down(fault.way, result);
        return result;
    };
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const std::filesystem::path folder = words.at(0);
    const int threads = std::stoi(words.at(3));
    const std::size_t slash = words[3].find('/');
    const int writers = slash == std::string::npos ? 0 : std::stoi(words[3].substr(slash + 1));
    Fault fault{folder / "broke", "", -1};
    const bool many = words.size() > 5 && words[4] == "members";
    const int count = many ? std::stoi(words[5]) : 30;
    if (words.size() > 5 && !many) fault = {folder / "broke", words[4], std::stoi(words[5])};
    const MemberFunction compute = computing(fault, many);
    const SilenceLimits patience = many ? SilenceLimits{.sign_of_life = 1, .with_a_worker = 20, .with_the_master = 40}
                                        : SilenceLimits{.sign_of_life = 0.1, .with_a_worker = 1, .with_the_master = 2};
    Helper helper(compute);
    const std::unique_ptr<Link> link = open_link(20);
    std::ofstream(folder / ("rank" + std::to_string(link->rank()))) << ::getpid() << " " << helper.pid() << "\n";
    if (link->rank() != 0) return serve_campaign(*link, threads, compute, &helper, patience);
    return lead_ranks(*link, std::cerr, [&] {
        Campaign campaign = synthetic::campaign(count / 3);
        campaign.run = {.isolation = words.at(2) == "process" ? Isolation::process : Isolation::none,
                        .member_deadline = 1,
                        .member_memory = 64.0 * 1024 * 1024};
        if (many) campaign.run.attempts = 100;
        const RunOptions options{.places = {.campaign_file = folder / words.at(1), .existing = Existing::resume},
                                 .threads = threads,
                                 .writers = writers,
                                 .resume_command = "the same",
                                 .patience = patience};
        Progress progress(std::cerr, Progress::Style::plain);
        return run_campaign(campaign, options, *link, compute, progress, &helper);
    });
}
