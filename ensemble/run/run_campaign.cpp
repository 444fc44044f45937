#include "run/run_campaign.hpp"

#include <unistd.h>

#include <array>
#include <chrono>
#include <exception>
#include <filesystem>
#include <thread>

#include <fmt/format.h>

#include "campaign/identity.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "run/link.hpp"
#include "run/master.hpp"
#include "run/ranks.hpp"
#include "run/worker.hpp"

namespace floes {

namespace {

std::string opening(const Campaign& campaign, const RunOptions& options, int ranks, int cores) {
    return fmt::format("{}: {} = {} x {} on {}{}, into {}", campaign.name, counted(member_count(campaign), "member"),
                       counted(std::ssize(campaign.cases), "case"), counted(campaign.arrangements, "arrangement"),
                       counted(cores, "core"), ranks > 1 ? fmt::format(" of {} ranks", ranks) : "",
                       options.places.campaign_file.string());
}

std::string part_text(const CampaignPart& part, const Inventory& found) {
    return fmt::format("part {} of {}: {} of these members", part.number, part.of, found.total);
}

/// What earlier sessions left; empty if nothing.
std::string stock(const Inventory& found) {
    if (found.reused() + found.retried == 0) return {};
    return fmt::format("resumed: {} reused, {} to compute{}", counted(found.reused(), "member"), found.tasks.size(),
                       found.retried > 0 ? fmt::format(", {} of them retried", found.retried) : "");
}

/// What this session did.
std::string harvest(const Tally& tally) {
    return fmt::format("{} reused, {} computed, {} retried, {} set aside", counted(tally.found().reused(), "member"),
                       tally.computed(), tally.found().retried, tally.set_aside());
}

/// Throws unless rank 0 sees the pieces that others have opened: results on another node's own disk would be lost.
void expect_to_see_pieces(const Groups& groups, const std::filesystem::path& journal) {
    constexpr std::chrono::seconds longest{60};  // for which a shared file system may remember that there was none
    const auto deadline = std::chrono::steady_clock::now() + longest;
    for (const int writer : groups.writers()) {
        const std::filesystem::path piece = piece_path(journal, groups.piece_of(writer));
        while (!std::filesystem::exists(piece)) {
            if (std::chrono::steady_clock::now() > deadline)
                throw RunError(fmt::format(
                    "{}, which rank {} has opened, is not to be seen by rank 0. All ranks that keep results "
                    "need one folder: give -o on a shared file system, or --writers 1.",
                    piece.string(), writer));
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
    }
}

Session session_of(int ranks, int cores) {
    return describe_session(ranks, cores, std::array{Software{"MPI", library_version()}});
}

/// After all arrangements, where the stop rule is not met.
std::string imprecise_sentence(const Campaign& campaign, PrecisionStop precision) {
    precision.look();
    const std::string all = fmt::format("all {} arrangements are done and", campaign.arrangements);
    if (const std::string obstacle = precision.obstacle(); !obstacle.empty())
        return fmt::format("{} the half-width is not known, target {:g} %: {}", all, 100 * precision.target(),
                           obstacle);
    const std::string reached =
        precision.achieved() <= precision.target()
            ? fmt::format(", but not met for stop.look_ahead = {} arrangements in a row after {}",
                          campaign.stop.look_ahead, precision.minimum())
            : "; to continue, raise campaign.arrangements and resume";
    return fmt::format("{} the half-width is {:.1f} %, target {:g} %{}", all, 100 * precision.achieved(),
                       100 * precision.target(), reached);
}

/// Prints the final messages and returns the exit status.
int conclude(const Campaign& campaign, const RunOptions& options, Recorder& recorder, Progress& progress,
             const Master& master) {
    const std::string stopped_by = master.stopped_by();
    const Tally& tally = recorder.tally();
    const int lost = options.places.with_file || master.lost_a_writer() ? recorder.take_in_pieces() : 0;
    const bool resumed = recorder.journal().sessions().size() > 1;
    const std::string file = options.places.campaign_file.string();
    const int total = tally.precise() ? member_count(tally.published()) : tally.found().total;
    if (lost > 0 && stopped_by.empty()) {
        progress.say(
            fmt::format("{} of this run {} in no journal, since a rank that kept results was lost; to resume: {}",
                        counted(lost, "member"), lost == 1 ? "is" : "are", options.resume_command));
        recorder.finish("members were lost");
        return exit_stopped;
    }
    if (tally.precise()) {
        const PrecisionStop& precision = *tally.precision();
        progress.say(fmt::format(
            "precise enough after {} of at most {} arrangements: half-width {:.1f} %, target {:g} %",
            precision.arrangements(), campaign.arrangements, 100 * precision.achieved(), 100 * precision.target()));
    } else if (const auto& together = recorder.together(); together && !stopped_by.empty()) {
        progress.say(fmt::format(
            "precise enough: all parts together have the half-width {:.1f} %, target {:g} %, after {} of at most {} "
            "arrangements, so what is left of this part is not needed",
            100 * together->achieved(), 100 * together->target(), together->arrangements(), campaign.arrangements));
    } else if (!stopped_by.empty()) {
        recorder.sync();  // before anything slow, because the batch system may kill the run soon
        if (resumed) progress.say(harvest(tally));
        progress.say(fmt::format("stopped by {} with {} of {} done and on the disk; to resume: {}", stopped_by,
                                 tally.done() + tally.failed(), counted(total, "member"), options.resume_command));
        recorder.finish("stopped");
        return exit_stopped;
    }
    if (resumed) progress.say(harvest(tally));
    recorder.finish(tally.failed() > 0 ? "complete, members failed" : "complete");
    if (const auto& precision = tally.precision(); precision && !tally.precise())
        progress.say(imprecise_sentence(campaign, *precision));
    if (tally.failed() > 0) {
        progress.say(fmt::format("{} of {} failed and {} missing in {}; floes status {} shows the reasons",
                                 tally.failed(), counted(total, "member"), tally.failed() == 1 ? "is" : "are", file,
                                 file));
        return 1;
    }
    return 0;
}

}  // namespace

int run_campaign(const Campaign& campaign, const RunOptions& options, Link& link, const MemberFunction& compute,
                 Progress& progress, Helper* helper) {
    const StopSignals signals;
    Recorder recorder(campaign, options.places);
    const Hello own{threads_of(link, options.threads), host_name(), fingerprint(campaign), ::getpid()};
    const Groups groups(link.size(), options.writers);
    const Muster mustered =
        muster(link, campaign, groups, journal_path(options.places.campaign_file), own, options.patience);
    expect_to_see_pieces(groups, journal_path(options.places.campaign_file));
    progress.say(opening(campaign, options, link.size(), mustered.cores()));
    if (options.places.part.of > 1) progress.say(part_text(options.places.part, recorder.tally().found()));
    if (const std::string remark = binding_remark(link.topology()); !remark.empty()) progress.say(remark);
    if (recorder.journal().damaged_bytes() > 0) {
        progress.say(
            fmt::format("{} bytes of the journal are damaged and were skipped; the members in them are computed "
                        "again. Is the disk failing?",
                        recorder.journal().damaged_bytes()));
    }
    for (const std::string& line : recorder.journal().extension()) {
        progress.say(fmt::format("the campaign is extended, existing results are kept: {}", line));
    }
    for (const std::string& change : recorder.begin(session_of(link.size(), mustered.cores()))) {
        progress.say(
            fmt::format("the earlier members may differ in the last bits from results of this program; {}", change));
    }
    if (const std::string text = stock(recorder.tally().found()); !text.empty()) progress.say(text);
    Master master(campaign, {link, groups, recorder, progress, signals}, {compute, own.cores, helper}, mustered,
                  {options.walltime, options.patience});
    try {
        master.run();
    } catch (...) {
        recorder.give_up();
        throw;
    }
    const int status = conclude(campaign, options, recorder, progress, master);
    master.part();
    return status;
}

int lead_ranks(Link& link, std::ostream& errors, const std::function<int()>& body) {
    int status = 1;
    try {
        status = body();
    } catch (const InputError& error) {
        errors << fmt::format("floes: {}\n", error.what());
        status = 2;
    } catch (const std::exception& error) {
        errors << fmt::format("floes: {}\n", error.what());
    }
    for (int rank = 1; rank < link.size(); ++rank) link.send(rank, Tag::leave, encode_status(status));
    return status;
}

}  // namespace floes
