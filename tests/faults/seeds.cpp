// Histories of campaigns on a simulated machine, faults/history.hpp.
//
//     seeds [--from SEED] COUNT            exit status 1 if one does not hold; the first twenty are told
//     seeds --seed SEED [MUTANT]           one, and what happened in it
//     seeds --mutants COUNT                each driver that is wrong is found out by so many
//
// A driver that is wrong: "sync", a sync left out; "rename", a rename before the sync; "append", a count before the
// append; "folder", the sync of a folder left out.

#include <malloc.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "faults/history.hpp"

namespace {

using namespace floes;
using namespace floes::simulated;

/// The number of the first seed that does not hold, from `from` on; -1 if all hold.
std::int64_t first_fault(const std::vector<Subject>& subjects, std::int64_t from, std::int64_t count,
                         const Mutant& mutant, std::string& fault) {
    for (std::int64_t seed = from; seed < from + count; ++seed) {
        fault = history(subjects, static_cast<std::uint64_t>(seed), mutant);
        if (!fault.empty()) return seed;
    }
    return -1;
}

/// Each found a fault of the driver that is mended (docs/trust.md), in what it drew then: a torn header, one with
/// records behind it, twice a writer that told before it synced, the torn header of a campaign that has grown, and an
/// overwritten journal whose cut was lost.
constexpr std::array<std::int64_t, 6> found_a_fault{206, 1069, 438572, 613927, 11186, 502534};

/// Whether a history is told again as it was.
bool is_replayed(const std::vector<Subject>& subjects, std::int64_t seed) {
    std::array<std::string, 2> accounts;
    for (std::string& account : accounts) history(subjects, static_cast<std::uint64_t>(seed), {}, &account);
    if (accounts[0] != accounts[1]) fmt::print("seed {} is not replayed:\n{}\n{}", seed, accounts[0], accounts[1]);
    return accounts[0] == accounts[1];
}

int run(const std::vector<Subject>& subjects, std::int64_t from, std::int64_t count) {
    constexpr int most_told = 20;
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t begin_of_work = std::clock();
    int faults = 0;
    std::vector<std::int64_t> known;
    std::ranges::copy_if(found_a_fault, std::back_inserter(known), [&](std::int64_t seed) { return seed >= count; });
    for (const std::int64_t seed : known)
        if (std::string fault; first_fault(subjects, seed, 1, {}, fault) >= 0) {
            fmt::print("seed {}: {}\n", seed, fault);
            ++faults;
        }
    for (std::int64_t seed = from; seed < from + std::min<std::int64_t>(count, 100); ++seed)
        if (!is_replayed(subjects, seed)) return 1;
    for (std::int64_t next = from; next < from + count && faults < most_told; ++next) {
        std::string fault;
        next = first_fault(subjects, next, from + count - next, {}, fault);
        if (next < 0) break;
        fmt::print("seed {}: {}\n", next, fault);
        std::fflush(stdout);
        ++faults;
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    const double work = static_cast<double>(std::clock() - begin_of_work) / CLOCKS_PER_SEC;
    fmt::print("{} seeds from {} on, {} failed, {:.0f} s, {:.0f} s of the processor\n", count, from,
               faults == 0 ? "none" : std::to_string(faults), taken.count(), work);
    return faults == 0 ? 0 : 1;
}

/// A driver that is wrong, played by the disk.
const std::vector<std::pair<std::string, Mutant>> mutants{{"sync", {.sync_left_out = true}},
                                                          {"rename", {.rename_too_early = true}},
                                                          {"append", {.append_too_late = true}},
                                                          {"folder", {.folder_not_synced = true}}};

int find_mutants(const std::vector<Subject>& subjects, std::int64_t count) {
    int missed = 0;
    for (const auto& [name, mutant] : mutants) {
        std::string fault;
        const std::int64_t seed = first_fault(subjects, 0, count, mutant, fault);
        if (seed >= 0) fmt::print("{}: found by seed {}: {}\n", name, seed, fault);
        if (seed < 0) fmt::print("{}: not found by {} seeds\n", name, count);
        missed += seed < 0 ? 1 : 0;
    }
    return missed;
}

int tell(const std::vector<Subject>& subjects, std::int64_t seed, const std::string& name) {
    const auto of_that_name = std::ranges::find(mutants, name, &std::pair<std::string, Mutant>::first);
    std::string account;
    const Mutant mutant = of_that_name == mutants.end() ? Mutant{} : of_that_name->second;
    const std::string fault = history(subjects, static_cast<std::uint64_t>(seed), mutant, &account);
    fmt::print("{}{}\n", account, fault.empty() ? "all holds" : fault);
    return fault.empty() ? 0 : 1;
}

/// -1 of a word that is not there, or is no whole number from 0 on.
std::int64_t number_in(const std::vector<std::string>& words, std::size_t place) {
    if (place >= words.size()) return -1;
    std::int64_t number = -1;
    const char* const end = words[place].data() + words[place].size();
    const auto [read, error] = std::from_chars(words[place].data(), end, number);
    return error == std::errc() && read == end ? number : -1;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    ::mallopt(M_TRIM_THRESHOLD,
              1 << 28);  // memory given back to the system after each history took a quarter of the time
    const std::vector<Subject> subjects = make_subjects();
    const std::int64_t first = number_in(words, 0);
    const std::int64_t second = number_in(words, 1);
    const std::int64_t third = number_in(words, 2);
    if (words.size() == 2 && words[0] == "--mutants" && second >= 0) return find_mutants(subjects, second);
    if (words.size() >= 2 && words[0] == "--seed" && second >= 0)
        return tell(subjects, second, words.size() > 2 ? words[2] : "");
    if (words.size() == 3 && words[0] == "--from" && second >= 0 && third >= 0) return run(subjects, second, third);
    if (words.size() == 1 && first >= 0) return run(subjects, 0, first);
    fmt::print(stderr, "seeds [--from SEED] COUNT | --seed SEED [MUTANT] | --mutants COUNT\n");
    return 2;
}
