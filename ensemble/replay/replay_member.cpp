#include "replay/replay_member.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <ranges>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/campaign.hpp"
#include "campaign/write.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "member/array_output.hpp"
#include "member/quantity.hpp"
#include "member/run_member.hpp"
#include "shapes/moorings.hpp"

namespace floes {

namespace {

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

void compare_quantities(const MemberRow& stored, const MemberResult& now, std::vector<std::string>& found) {
    for (const Quantity& one : quantities) {
        const double there = one.of(stored);
        if (std::isnan(there) && one.since > 0) continue;  // older files do not have it
        const double here = one.of(now);
        if (!same_bits(there, here))
            found.push_back(fmt::format("{} is {:.17g} in the file and {:.17g} now.", one.key, there, here));
    }
}

void compare_histories(const CampaignFile& file, int member, const MemberResult& now, std::vector<std::string>& found) {
    const auto compare = [&](const StoredHistory& stored) {
        const std::vector<double>& surge = now.history.surge;
        const auto [there, here] = std::ranges::mismatch(stored.values, surge, same_bits);
        if (there == stored.values.end() && here == surge.end()) return;
        found.push_back(fmt::format("the surge load differs from t = {:.2f} s on.",
                                    stored.step * static_cast<double>(here - surge.begin() + 1)));
    };
    for_each_history(file, array_output("history/surge_load"), compare, [member](int one) { return one == member; });
}

void compare_breaks(const CampaignFile& file, int member, const MemberResult& now, std::vector<std::string>& found) {
    std::vector<BreakRow> stored = read_breaks(file);
    std::erase_if(stored, [&](const BreakRow& row) { return row.member != member; });
    const bool same = std::ranges::equal(stored, now.breaks, [](const BreakRow& there, const BreakEvent& here) {
        return same_bits(there.time, here.time) && there.floe == here.floe && there.mode == static_cast<int>(here.mode);
    });
    if (same) return;
    found.push_back(fmt::format("{} failed in the file and {} now, or others did.",
                                counted(static_cast<int>(stored.size()), "joint"), now.breaks.size()));
}

/// Adds the last step of a run to a history of its own, which is kept whole where the member's is thinned.
void add_last(const LoadHistory& of_run, LoadHistory& history) {
    for (const auto& one : load_histories) (history.*one.values).push_back((of_run.*one.values).back());
}

/// A campaign of the one case, whose Σ and E are what the file says they were found to be.
Campaign with_case(const Campaign& whole, int case_index, const CaseRow& stored) {
    Campaign campaign = whole;
    Case one = whole.cases.at(static_cast<std::size_t>(case_index));
    if (one.pairing == Pairing::find_cfm) one.scenario.joint.cfm = stored.cfm;
    if (one.pairing == Pairing::find_modulus) one.scenario.ice.elastic_modulus = stored.elastic_modulus;
    one.pairing = Pairing::settled;
    one.base.clear();
    one.point = -1;
    campaign.cases = {std::move(one)};
    campaign.design = {};
    campaign.stop = {};
    campaign.run.base_case.clear();  // of the whole
    return campaign;
}

}  // namespace

FrameSteps frame_steps(const FrameTimes& times, const Scenario& scenario) {
    const double step = scenario.general.time_step;
    const double end = step * scenario.step_count();
    if (!(times.from <= times.to) || times.to < 0 || times.from > end + step / 2)
        throw InputError(
            fmt::format("There are no frames from {:g} s to {:g} s: the run goes from 0 s to {:g} s; give --from and "
                        "--to within it.",
                        times.from, times.to, end));
    const auto nearest = [&](double time) { return static_cast<int>(std::llround(std::clamp(time, 0.0, end) / step)); };
    FrameSteps steps{nearest(times.from), nearest(times.to), std::max(1, nearest(times.every))};
    const int through = nearest(times.through);
    if (through >= steps.first && through <= steps.last) steps.first += (through - steps.first) % steps.stride;
    return steps;
}

ReplaySubject replay_subject(const CampaignFile& file, const CampaignTable& table, int member) {
    const Campaign& campaign = file.campaign();
    if (member < 0 || member >= static_cast<int>(table.members.size()))
        throw InputError(fmt::format("{} has no member {}: its members are 0 to {}.", file.path().string(), member,
                                     static_cast<int>(table.members.size()) - 1));
    const MemberKey key = member_key(campaign, member);
    const auto row = static_cast<std::size_t>(key.case_index);
    ReplaySubject subject;
    subject.file = file.path();
    subject.stored = table.members[static_cast<std::size_t>(member)];
    subject.seed = arrangement_seed(campaign, key.case_index);
    const Campaign one = with_case(campaign, key.case_index, table.cases.at(row));
    subject.about = {
        .campaign = campaign.name,
        .fingerprint = fingerprint(campaign),
        .configuration = write_campaign(one),
        .case_name = campaign.cases[row].name,
        .member = member,
        .arrangement = key.arrangement,
        .scenario = one.cases.front().scenario,
        .floes = floes_of(one.cases.front().scenario, {subject.seed, static_cast<std::uint32_t>(key.arrangement)})};
    return subject;
}

namespace {

/// Histories that what is asked follows from.
std::vector<const ArrayOutput*> histories_of(AskedOf of) {
    switch (of) {
        case AskedOf::load:
            return {&array_output("history/surge_load")};
        case AskedOf::mooring_force:
            return {&array_output("history/surge_mooring"), &array_output("history/sway_mooring")};
        case AskedOf::offset:
            return {&array_output("history/surge_offset"), &array_output("history/sway_offset"),
                    &array_output("history/structure_yaw")};
        case AskedOf::tension:
            break;
    }
    return {};
}

struct LargestValue {
    double value = 0;
    double time = 0;  ///< s
};

/// In the window; none where that is empty. The mean of all of what is averaged lies in it. Throws InputError where
/// none of that time does.
std::optional<LargestValue> largest_in(const StoredHistories& histories, const Asked& asked, const Scenario& scenario,
                                       const std::string& case_name) {
    if (const std::string words = averaging_refusal(asked, histories.step, scenario.analysis.window); !words.empty())
        throw InputError(fmt::format("Case {}: {}.", case_name, words));
    const std::vector<std::span<const double>>& of = histories.values;
    std::vector<double> values(of.front().begin(), of.front().end());
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (asked.of == AskedOf::mooring_force) values[k] = std::hypot(of[0][k], of[1][k]);
        if (asked.of == AskedOf::offset) values[k] = horizontal_offset(scenario.moorings, of[0][k], of[1][k], of[2][k]);
    }
    const std::span<const double> window = in_window({histories.member, histories.step, values}, scenario.analysis);
    if (window.empty()) return {};
    const std::vector<double> means = asked_history(asked, window, histories.step);
    const std::size_t count = std::min(averaged_values(asked, histories.step), window.size());
    const auto most = std::ranges::max_element(means);
    const auto place =
        std::clamp(static_cast<std::size_t>(most - means.begin()), count / 2, window.size() - count + count / 2);
    return LargestValue{*most, histories.step * static_cast<double>(values.size() - window.size() + place + 1)};
}

}  // namespace

double time_of_largest(const ReplaySubject& subject) {
    double time = undefined;
    const std::vector<const ArrayOutput*> of = histories_of(subject.about.asked.of);
    if (of.empty()) return time;
    for_each_histories(
        subject.file, of, [&](int member) { return member == subject.about.member; },
        [&](const StoredHistories& histories) {
            const auto found =
                largest_in(histories, subject.about.asked, subject.about.scenario, subject.about.case_name);
            if (found) time = found->time;
        });
    return time;
}

double time_of_largest_tension(const ReplaySubject& subject, const std::stop_token& stop,
                               const ReplayProgress& progress) {
    double time = undefined;
    if (subject.about.scenario.moorings.line_count() == 0) return time;
    HullHistory hull;
    double most = -std::numeric_limits<double>::infinity();
    const Watcher watch = [&](const Simulation& run) {
        if (run.steps() > 0) hull.add_last(run, subject.about.scenario.moorings);
        if (!hull.tension.empty() && hull.tension.back() > most) {
            most = hull.tension.back();
            time = run.time();
        }
        if (progress) progress(run.time());
    };
    run_member(subject.about.scenario, subject.seed, static_cast<std::uint32_t>(subject.about.arrangement), stop,
               watch);
    return time;
}

std::vector<double> largest_values(const CampaignFile& file, const CampaignTable& table, const Asked& asked,
                                   const std::string& case_name) {
    std::vector<double> values(table.members.size(), undefined);
    const bool of_step = asked.of == AskedOf::load && !asked.averaged();
    if (of_step || asked.of == AskedOf::tension) {
        const Quantity& from = *find_quantity(of_step ? "maximum_load" : "largest_line_tension");
        for (std::size_t k = 0; k < values.size(); ++k) values[k] = table.members[k].value(from);
        return values;
    }
    const auto case_of = [&](int member) -> const Case& {
        return file.campaign().cases.at(static_cast<std::size_t>(member_key(file.campaign(), member).case_index));
    };
    const auto wanted = [&](int member) { return case_name.empty() || case_of(member).name == case_name; };
    for_each_histories(file, histories_of(asked.of), wanted, [&](const StoredHistories& histories) {
        const Case& one = case_of(histories.member);
        const auto found = largest_in(histories, asked, one.scenario, one.name);
        if (found) values.at(static_cast<std::size_t>(histories.member)) = found->value;
    });
    return values;
}

std::vector<std::string> differences(const ReplaySubject& subject, const MemberResult& result) {
    std::vector<std::string> found;
    const bool failed = result.status == MemberStatus::failed;
    if (subject.stored.status == RowStatus::missing) return {"the file does not have the member yet."};
    if (failed != (subject.stored.status == RowStatus::failed)) {
        return {fmt::format("the member {} in the file and {} now.", failed ? "ended" : "failed",
                            failed ? "fails: " + result.reason : "ends")};
    }
    if (failed) return {};
    compare_quantities(subject.stored, result, found);
    const CampaignFile file(subject.file);
    compare_histories(file, subject.about.member, result, found);
    compare_breaks(file, subject.about.member, result, found);
    return found;
}

MemberResult replay(const ReplaySubject& subject, const FrameSteps& steps, const std::filesystem::path& path,
                    const std::stop_token& stop, const ReplayProgress& progress) {
    const RecordingSubject& about = subject.about;
    RecordingWriter recording(path, about);
    const bool endless = about.scenario.field.endless();
    FloeRoll roll;
    Frame frame;
    LoadHistory history;
    HullHistory hull;
    const Watcher watch = [&](const Simulation& run) {
        if (steps.has(run.steps())) {
            run.read_frame(frame);
            if (endless) roll.enter(run, frame);
            recording.add(frame);
        }
        if (run.steps() > 0) {
            add_last(run.loads(), history);
            hull.add_last(run, about.scenario.moorings);
        }
        if (progress) progress(run.time());
    };
    MemberResult result =
        run_member(about.scenario, subject.seed, static_cast<std::uint32_t>(about.arrangement), stop, watch);
    recording.finish({std::move(history), endless ? roll.breaks(result.breaks) : result.breaks, std::move(hull)}, roll);
    return result;
}

KeyFrames key_frames(const ReplaySubject& subject, double worst_at, const std::stop_token& stop) {
    const Scenario& scenario = subject.about.scenario;
    const bool endless = scenario.field.endless();
    KeyFrames kept;
    FloeRoll begun;  // of the start alone: what a load shows that another exceeds is not kept
    FloeRoll roll;
    const auto read = [&](const Simulation& run, Frame& frame) {
        run.read_frame(frame);
        if (endless) roll.enter(run, frame);
    };
    double largest = -std::numeric_limits<double>::infinity();
    const Watcher watch = [&](const Simulation& run) {
        if (run.steps() == 0) {
            read(run, kept.start);
            begun = roll;
            return;
        }
        add_last(run.loads(), kept.history);
        kept.hull.add_last(run, scenario.moorings);
        const double load = run.loads().surge.back();
        const bool worst = std::isnan(worst_at) ? run.steps() > scenario.first_window_step() && load > largest
                                                : run.steps() == std::lround(worst_at / scenario.general.time_step);
        if (worst) {
            largest = load;
            roll = begun;
            read(run, kept.worst);
        }
        if (run.steps() == scenario.step_count()) read(run, kept.end);
    };
    kept.result =
        run_member(scenario, subject.seed, static_cast<std::uint32_t>(subject.about.arrangement), stop, watch);
    kept.about = subject.about;
    kept.breaks = endless ? roll.breaks(kept.result.breaks) : kept.result.breaks;
    if (!endless) return kept;
    kept.about.floes = roll.floes();
    const std::array way{kept.start.structure.position.x(), kept.worst.structure.position.x(),
                         kept.end.structure.position.x()};
    kept.about.way = {std::ranges::min(way), std::ranges::max(way)};
    return kept;
}

namespace {

constexpr double round_worst = 10;  // s of frames before and after the largest load
constexpr double long_span = 60;    // s; of longer ones fewer frames are kept
constexpr double short_every = 0.1;
constexpr double long_every = 0.25;

/// Why there is none.
const char* lacks(AskedOf of) {
    switch (of) {
        case AskedOf::load:
            return "it keeps no load histories (analysis.history_steps = 0)";
        case AskedOf::tension:
            return "it has no mooring lines (moorings.lines or hanging_lines)";
        case AskedOf::mooring_force:
        case AskedOf::offset:
            break;
    }
    return "its structure does not give way (moorings.mass_t), or it keeps no histories (analysis.history_steps = 0)";
}

int largest_of_members(const CampaignTable& table, const MemberChoice& choice, std::span<const double> values,
                       const Asked& asked) {
    std::optional<int> worst;
    bool done = false;
    for (int k = 0; k < std::ssize(values); ++k) {
        if (!choice.leaves(table, k)) continue;
        done = true;
        const double value = values[static_cast<std::size_t>(k)];
        if (!std::isnan(value) && (!worst || value > values[static_cast<std::size_t>(*worst)])) worst = k;
    }
    if (worst) return *worst;
    if (!done)
        throw InputError(fmt::format("None of these members is done, so none has a largest {} yet.", asked.words()));
    throw InputError(fmt::format("None of these members has a {}: {}.", asked.words(), lacks(asked.of)));
}

}  // namespace

bool MemberChoice::leaves(const CampaignTable& table, int member) const {
    const MemberRow& row = table.members[static_cast<std::size_t>(member)];
    const auto cases = static_cast<int>(table.cases.size());
    return row.done() &&
           (case_name.empty() || table.cases[static_cast<std::size_t>(row.case_index)].name == case_name) &&
           (!arrangement || member / cases == *arrangement);
}

int chosen_member(const CampaignTable& table, const MemberChoice& choice, std::span<const double> values,
                  const Asked& asked) {
    if (choice.number) return *choice.number;
    const auto cases = static_cast<int>(table.cases.size());
    const int arrangements = static_cast<int>(table.members.size()) / std::max(cases, 1);
    const auto named = std::ranges::find(table.cases, choice.case_name, &CaseRow::name);
    if (!choice.case_name.empty() && named == table.cases.end())
        throw InputError(fmt::format("There is no case {}; the cases are {}.", choice.case_name,
                                     fmt::join(table.cases | std::views::transform(&CaseRow::name), ", ")));
    if (choice.arrangement.value_or(0) >= arrangements)
        throw InputError(fmt::format("There is no arrangement {}; the arrangements are 0 to {}.", *choice.arrangement,
                                     arrangements - 1));
    const bool any_case = choice.case_name.empty();
    const auto case_index = static_cast<int>(named - table.cases.begin());
    if (choice.worst) return largest_of_members(table, choice, values, asked);
    if ((any_case && cases > 1) || (!choice.arrangement && arrangements > 1))
        throw InputError(
            "Which member? Give its number, --case and --arrangement, or --worst for the one with the largest load.");
    return choice.arrangement.value_or(0) * cases + (any_case ? 0 : case_index);
}

FrameTimes chosen_times(const ReplaySubject& subject, const TimeChoice& choice) {
    const Scenario& scenario = subject.about.scenario;
    const double end = scenario.general.time_step * scenario.step_count();
    FrameTimes times{.from = 0, .to = end, .every = 0, .through = 0};
    if (choice.worst) {
        if (subject.stored.status == RowStatus::missing)
            throw InputError(fmt::format(
                "Member {} is not in {} yet, so nothing says when its largest {} comes: leave --worst out, or "
                "compute the rest of the campaign first, floes run CONFIG.toml -o {} --resume.",
                subject.about.member, subject.file.string(), subject.about.asked.words(),
                shell_word(subject.file.string())));
        times.through = choice.worst_at ? *choice.worst_at : time_of_largest(subject);
        if (std::isnan(times.through))
            throw InputError(fmt::format(
                "{} does not say when the largest {} of member {} came: {}. Give --from and --to instead of --worst.",
                subject.file.string(), subject.about.asked.words(), subject.about.member,
                lacks(subject.about.asked.of)));
        times.from = std::max(0.0, times.through - round_worst);
        times.to = std::min(end, times.through + round_worst);
    }
    times.from = choice.from.value_or(times.from);
    times.to = choice.to.value_or(times.to);
    times.every = choice.every.value_or(times.to - times.from > long_span ? long_every : short_every);
    return times;
}

}  // namespace floes
