// What floes status --watch shows of a moment: words, bars and a figure, as wide and high as the terminal is.

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <sstream>

#include "cli/commands.hpp"
#include "cli/watch.hpp"
#include "findings/evidence.hpp"
#include "findings/summary.hpp"
#include "inference/interval.hpp"
#include "member/quantity.hpp"
#include "tables/table.hpp"

namespace floes {

namespace {

using Lines = std::vector<std::string>;

constexpr int side_by_side = 120;      // columns from which on there are two of them
constexpr std::size_t most_drawn = 6;  // cases in the figure

/// Of the mean over the first members, as many as are drawn.
std::vector<std::pair<int, double>> half_widths(const std::vector<double>& values) {
    constexpr std::size_t most = 60;
    std::vector<std::pair<int, double>> found;
    const std::size_t count = values.size();
    const std::size_t points = std::min(most, count);
    for (std::size_t k = 1; k <= points; ++k) {
        const std::size_t members = k * count / points;
        const Interval one = mean_interval(std::span(values).first(members));
        const double share = (one.high - one.low) / 2 / std::abs(one.estimate);
        if (std::isfinite(share)) found.emplace_back(static_cast<int>(members), share);
    }
    return found;
}

}  // namespace

WatchedRun watched(const CampaignSnapshot& snapshot) {
    WatchedRun run{.status = snapshot.status, .loads = {}};
    const Sample sample(snapshot.table);
    double largest = 0;
    for (std::size_t k = 0; k < sample.cases.size(); ++k) {
        const std::vector<double> values = sample.values(sample.done(k), quantity("mean_load"));
        run.loads.push_back({over(sample, sample.done(k), quantity("mean_load")), half_widths(values)});
        const Estimate maximum = over(sample, sample.done(k), quantity("mean_maximum"));
        if (maximum.value > largest) largest = maximum.value;
    }
    run.units = Units(largest);
    return run;
}

namespace {

struct Signs {
    const char* done;
    const char* running;
    const char* failed;
    const char* missing;
};

Signs signs_of(Letters letters) {
    if (letters == Letters::unicode) return {"█", "▓", "×", "░"};
    return {"#", "+", "x", "."};
}

std::string repeated(const char* sign, int count) {
    std::string text;
    for (int k = 0; k < count; ++k) text += sign;
    return text;
}

/// Every kind that there is gets a character at least.
std::string bar(const CaseStatus& one, int running, int width, const Signs& signs) {
    const int all = std::max(1, members_of(one));
    const auto share = [&](int count) {
        return count == 0 ? 0 : std::max(1, static_cast<int>(std::lround(double(count) * width / all)));
    };
    const int failed = std::min(share(one.failed), width);
    const int at_work = std::min(share(std::min(running, one.missing)), width - failed);
    const int to_do = one.missing > running ? 1 : 0;  // a place is kept for those that are left
    const int done = std::clamp(share(one.done), 0, std::max(0, width - failed - at_work - to_do));
    return repeated(signs.done, done) + repeated(signs.failed, failed) + repeated(signs.running, at_work) +
           repeated(signs.missing, width - done - failed - at_work);
}

/// The first characters, of UTF-8.
std::string cut(const std::string& text, int width) {
    std::string kept;
    int count = 0;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t next = at + 1;
        while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xC0) == 0x80) ++next;
        if (count++ == width) break;
        kept += text.substr(at, next - at);
        at = next;
    }
    return kept;
}

std::string filled(const std::string& text, int width) {
    const std::string kept = cut(text, width);
    return kept + std::string(static_cast<std::size_t>(width) - text_width(kept), ' ');
}

std::string in_ascii(const std::string& text) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 6> signs{
        {{"±", "+-"}, {"–", "-"}, {"×", "x"}, {"≤", "<="}, {"≥", ">="}, {"°", "deg"}}};
    std::string plain;
    for (std::size_t at = 0; at < text.size();) {
        const auto known = std::ranges::find_if(
            signs, [&](const auto& sign) { return text.compare(at, sign.first.size(), sign.first) == 0; });
        if (known != signs.end()) {
            plain += known->second;
            at += known->first.size();
            continue;
        }
        const auto letter = static_cast<unsigned char>(text[at]);
        if (letter >= 0x20 && letter < 0x7F) plain += text[at];
        if (letter >= 0xC0) plain += '?';
        ++at;
    }
    return plain;
}

void add_wrapped(Lines& lines, const std::string& sentence, int width) {
    std::istringstream text(wrapped(sentence, width));
    for (std::string line; std::getline(text, line);) lines.push_back(line);
}

std::string bytes_text(double bytes) {
    return bytes < 1024 * unit::mebibyte ? fmt::format("{:.0f} MiB", bytes / unit::mebibyte)
                                         : fmt::format("{:.1f} GiB", bytes / unit::mebibyte / 1024);
}

int running_in(const CampaignStatus& status, const std::string& case_name) {
    return static_cast<int>(std::ranges::count(status.under_way, case_name, &TimedMember::case_name));
}

/// What is said of the whole.
Lines head(const WatchedRun& run, const Screen& screen) {
    const CampaignStatus& status = run.status;
    const CaseStatus total = total_of(status);
    Lines lines{counts_sentence(status)};
    lines.push_back(
        bar(total, static_cast<int>(status.under_way.size()), std::min(screen.columns, 120), signs_of(screen.letters)));
    if (const std::string work = work_sentence(status); !work.empty()) add_wrapped(lines, work, screen.columns);
    if (run.memory)
        add_wrapped(lines,
                    fmt::format("Memory: {} of this run on this host{}.", bytes_text(*run.memory),
                                run.at_hand ? fmt::format(", {} at hand", bytes_text(*run.at_hand)) : ""),
                    screen.columns);
    if (status.stop) add_wrapped(lines, stop_sentence(*status.stop), screen.columns);
    return lines;
}

/// "21.3 ± 7.4 N": three digits of the mean, and as many decimals in both.
std::string load_text(const WatchedLoad& load, const Units& units, Letters letters) {
    const Units::Shown shown = units.of("N");
    const double mean = shown.factor * load.mean.value;
    if (!std::isfinite(mean)) return "-";
    const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(std::max(std::abs(mean), 1e-3)))), 0, 5);
    const bool known = load.mean.said && std::isfinite(load.mean.high);
    return fmt::format("{:.{}f}{} {}", mean, decimals,
                       known ? fmt::format(" {} {:.{}f}", letters == Letters::ascii ? "+-" : "±",
                                           shown.factor * (load.mean.high - load.mean.low) / 2, decimals)
                             : "",
                       shown.name);
}

/// Places of cases: all in order, or where there are more than `most`, the unfinished before the finished ones.
std::vector<std::size_t> shown_cases(const CampaignStatus& status, std::size_t most) {
    std::vector<std::size_t> places(status.cases.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    if (places.size() <= most) return places;
    std::ranges::stable_sort(places, std::greater{}, [&](std::size_t k) {
        const CaseStatus& one = status.cases[k];
        return one.missing > 0 ? 1 + running_in(status, one.name) : 0;
    });
    places.resize(most - 1);
    return places;
}

Lines cases(const WatchedRun& run, int width, int rows, Letters letters) {
    const CampaignStatus& status = run.status;
    const std::vector<std::size_t> places = shown_cases(status, static_cast<std::size_t>(std::max(2, rows - 2)));
    int names = 4;
    int loads = 9;
    for (const std::size_t k : places) {
        names = std::max(names, static_cast<int>(text_width(status.cases[k].name)));
        loads = std::max(loads, static_cast<int>(text_width(load_text(run.loads.at(k), run.units, letters))));
    }
    names = std::min(names, width / 4);
    const std::string most = fmt::format("{}", members_of(total_of(status)));
    const int counts = static_cast<int>(2 * most.size()) + 4;
    const int bars = std::clamp(width - names - counts - loads - 6, 6, 60);
    const Signs signs = signs_of(letters);
    Lines lines{fmt::format("{}  {}  {}  {}", filled("case", names), filled("members", bars), filled("done", counts),
                            "mean load")};
    for (const std::size_t k : places) {
        const CaseStatus& one = status.cases[k];
        lines.push_back(fmt::format("{}  {}  {}  {}", filled(one.name, names),
                                    bar(one, running_in(status, one.name), bars, signs),
                                    filled(fmt::format("{} of {}", one.done, members_of(one)), counts),
                                    load_text(run.loads[k], run.units, letters)));
    }
    if (places.size() < status.cases.size())
        lines.push_back(fmt::format("and {} further cases", status.cases.size() - places.size()));
    lines.push_back(fmt::format("{} done  {} running  {} failed  {} to do; ± 95 % interval", signs.done, signs.running,
                                signs.failed, signs.missing));
    return lines;
}

Lines failures(const CampaignStatus& status, int width) {
    constexpr std::size_t most = 5;
    if (status.failures.empty()) return {};
    Lines lines{fmt::format("failed: {}", counted(std::ssize(status.failures), "member"))};
    const std::size_t first = status.failures.size() > most ? status.failures.size() - most : 0;
    for (std::size_t k = first; k < status.failures.size(); ++k) {
        const FailedMember& one = status.failures[k];
        Lines words;
        add_wrapped(words, fmt::format("{} ({}): {}", one.number, one.case_name, one.reason), width - 2);
        for (std::size_t line = 0; line < std::min<std::size_t>(2, words.size()); ++line)
            lines.push_back("  " + words[line]);
    }
    return lines;
}

Lines timed(const char* title, const std::vector<TimedMember>& members) {
    constexpr std::size_t most = 5;
    if (members.empty()) return {};
    Lines lines{title};
    for (std::size_t k = 0; k < std::min(most, members.size()); ++k) {
        const TimedMember& one = members[k];
        lines.push_back(fmt::format("  {} ({}{}): {}", one.number, one.case_name,
                                    one.attempt > 1 ? fmt::format(", attempt {}", one.attempt) : "", time_words(one)));
    }
    if (members.size() > most) lines.push_back(fmt::format("  and {} further", members.size() - most));
    return lines;
}

/// Half-widths over members, a letter for each case.
Lines convergence(const WatchedRun& run, int width, int rows) {
    double largest = 0;
    int members = 0;
    const std::size_t drawn = std::min(most_drawn, run.loads.size());
    // The first few intervals are so wide that nothing else would be seen.
    const auto counts = [](const std::pair<int, double>& one) { return one.first >= 4; };
    for (std::size_t k = 0; k < drawn; ++k)
        for (const auto& one : run.loads[k].half_widths) {
            if (!counts(one)) continue;
            largest = std::max(largest, one.second);
            members = std::max(members, one.first);
        }
    if (largest == 0 || width < 40 || rows < 6) return {};
    const int high = std::min(rows - 3, 14);
    const int wide = std::min(width - 8, 90);
    std::vector<std::string> grid(static_cast<std::size_t>(high), std::string(static_cast<std::size_t>(wide), ' '));
    std::string legend;
    for (std::size_t k = 0; k < drawn; ++k) {
        const char letter = static_cast<char>('a' + k);
        legend += fmt::format("{}{} {}", k == 0 ? "" : "  ", letter, run.status.cases.at(k).name);
        for (const auto& one : run.loads[k].half_widths) {
            if (!counts(one)) continue;
            const auto x = static_cast<std::size_t>(std::lround(double(one.first) / members * (wide - 1)));
            const auto y = static_cast<std::size_t>(std::lround((1 - one.second / largest) * (high - 1)));
            grid[y][x] = letter;
        }
    }
    Lines lines{"± of the mean load over members, %"};
    for (std::size_t row = 0; row < grid.size(); ++row) {
        const bool first = row == 0;
        const bool last = row + 1 == grid.size();
        lines.push_back(fmt::format("{:>6}|{}",
                                    first  ? fmt::format("{:.3g}", 100 * largest)
                                    : last ? "0"
                                           : "",
                                    grid[row]));
    }
    lines.push_back(fmt::format("{:>6}{:>{}}", "", members, wide + 1));
    lines.push_back(legend);
    return lines;
}

/// With an empty line between them; none of more than `rows` lines in all.
Lines stacked(const std::vector<Lines>& blocks, int rows) {
    Lines all;
    for (const Lines& block : blocks) {
        if (block.empty() || std::ssize(all) + 2 > rows) continue;
        if (!all.empty()) all.emplace_back();
        all.insert(all.end(), block.begin(), block.end());
    }
    if (std::ssize(all) > rows) all.resize(static_cast<std::size_t>(std::max(rows, 0)));
    return all;
}

}  // namespace

std::vector<std::string> watch_frame(const WatchedRun& run, const Screen& screen) {
    const int columns = std::max(20, screen.columns);
    Lines lines = head(run, screen);
    lines.emplace_back();
    const int rows = std::max(0, screen.rows - static_cast<int>(lines.size()) - 1);
    const CampaignStatus& status = run.status;
    if (columns >= side_by_side) {
        const int half = columns / 2 - 2;
        const Lines left = stacked({cases(run, half, rows - 4, screen.letters), failures(status, half)}, rows);
        const Lines right =
            stacked({convergence(run, half, rows - 9), timed("running, longest first", status.under_way),
                     timed("slowest", status.slowest)},
                    rows);
        for (std::size_t k = 0; k < std::max(left.size(), right.size()); ++k)
            lines.push_back(filled(k < left.size() ? left[k] : "", half + 4) + (k < right.size() ? right[k] : ""));
    } else {
        std::vector<Lines> blocks{cases(run, columns, std::max(5, rows - 8), screen.letters), failures(status, columns),
                                  timed("running, longest first", status.under_way), timed("slowest", status.slowest)};
        const int used = static_cast<int>(stacked(blocks, rows).size());
        blocks.push_back(convergence(run, columns, rows - used - 1));
        for (std::string& line : stacked(blocks, rows)) lines.push_back(std::move(line));
    }
    lines.resize(std::min(lines.size(), static_cast<std::size_t>(std::max(1, screen.rows - 1))));
    lines.emplace_back("q ends watching, not the run");
    for (std::string& line : lines) line = cut(screen.letters == Letters::ascii ? in_ascii(line) : line, columns);
    if (std::ssize(lines) > screen.rows) lines.resize(static_cast<std::size_t>(std::max(1, screen.rows)));
    return lines;
}

}  // namespace floes
