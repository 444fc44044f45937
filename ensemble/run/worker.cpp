#include "run/worker.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "campaign/campaign.hpp"
#include "campaign/read.hpp"
#include "core/error.hpp"
#include "run/hands.hpp"
#include "run/messages.hpp"
#include "run/signals.hpp"
#include "run/writer.hpp"
#include "store/session.hpp"

namespace floes {

namespace {

constexpr std::size_t most_held_back = 256;  // answers; bounds the size of a message

std::string no_file(const std::string& path) {
    throw InputError(fmt::format("The campaign that the master sent refers to the file {}.", path));
}

/// The next message, asleep until it comes.
Message wait_for_message(Link& link) {
    Pause pause = pause_between_polls(link.size());
    while (true) {
        if (auto message = link.poll()) return std::move(*message);
        std::this_thread::sleep_for(pause.next());
    }
}

/// A worker between hello and leave.
class Worker {
  public:
    Worker(Link& link, const Campaign& campaign, const Post& post, const CrewSetup& setup,
           const SilenceLimits& patience, const StopSignals& signals)
        : link_(link),
          campaign_(campaign),
          keeper_of_records_(post.writer),
          patience_(patience),
          signals_(signals),
          crew_(campaign, setup) {
        if (!post.journal.empty()) open_writer(campaign, post.journal);
        link_.send(master_rank, Tag::hello,
                   encode(Hello{setup.threads, host_name(), fingerprint(campaign), ::getpid()}));
    }

    int run() {
        while (!exit_status_) {
            if (advance()) pause_.something_happened();
            crew_.wait(pause_.next());
        }
        return *exit_status_;
    }

  private:
    void open_writer(const Campaign& campaign, const std::string& journal) {
        try {
            writer_.emplace(link_, campaign, journal);
        } catch (const InputError& error) {
            throw RunError(
                fmt::format("{} All ranks that keep results write into one folder; --writers 1 lets rank 0 "
                            "keep them alone.",
                            error.what()));
        }
    }

    /// Does all pending work. True if there was any.
    bool advance() {
        bool something = link_.moving();
        while (const auto message = link_.poll()) {
            if (message->from == master_rank) silence_.heard(master_rank);
            obey(*message);
            something = true;
        }
        for (Outcome& outcome : crew_.take()) {
            if (outcome.record) note_answer({outcome.number, std::move(*outcome.record)});
            something = true;
        }
        send_answers();
        if (writer_) writer_->tend();
        if (auto done = hand_.take()) {
            link_.send(master_rank, done->first, std::move(done->second));
            something = true;
        }
        if (const auto trouble = crew_.trouble(); trouble && !dismissed_) give_up(*trouble);
        if (dismissed_ && !said_farewell_ && crew_.held() == 0) {
            // Behind its answers. A writer sent what it has to the master.
            link_.send(writer_ ? master_rank : keeper_of_records_, Tag::farewell, {});
            said_farewell_ = true;
        }
        if (signals_.received() != 0 && !passed_signal_) {
            link_.send(master_rank, Tag::stop_request, {});
            passed_signal_ = true;
        }
        watch_master();
        return something;
    }

    void watch_master() {
        silence_.listened(std::chrono::steady_clock::now());
        if (silence_.total() < next_sign_) return;
        next_sign_ = silence_.total() + patience_.sign_of_life;
        link_.send(master_rank, Tag::alive, encode(crew_.progress()));
        if (silence_.of(master_rank) < patience_.with_the_master) return;
        fmt::print(stderr,
                   "floes: rank {} leaves, because the master has been silent for {:.0f} s; continue with --resume\n",
                   link_.rank(), silence_.of(master_rank));
        link_.abandon(master_rank);
        exit_status_ = 1;
    }

    void obey(const Message& message) {
        switch (message.tag) {
            case Tag::assign:
                for (const Assignment& assignment : decode<std::vector<Assignment>>(message.bytes))
                    crew_.begin(assignment);
                return;
            case Tag::dismiss:
                crew_.abandon();
                dismissed_ = true;
                return;
            case Tag::alive:
                return;
            case Tag::part:
                ranks_are_missing_ = true;
                return;
            case Tag::answer: {
                Writer& writer = expect_writer(message);
                for (Answer& answer : decode<std::vector<Answer>>(message.bytes))
                    writer.keep(message.from, std::move(answer));
                return;
            }
            case Tag::farewell:
                expect_writer(message).farewell(message.from);
                return;
            case Tag::close:
                expect_writer(message).sync();
                writer_.reset();
                link_.send(master_rank, Tag::closed, {});
                return;
            case Tag::publish:
                hand_.begin(Tag::published, [this, order = decode<PieceOrder>(message.bytes)] {
                    return encode(make_piece(campaign_, order));
                });
                return;
            case Tag::digest:
                hand_.begin(Tag::digested,
                            [order = decode<DigestOrder>(message.bytes)] { return encode(make_digests(order)); });
                return;
            case Tag::leave:
                if (ranks_are_missing_) {
                    link_.abandon(master_rank);
                    if (keeper_of_records_ != master_rank) link_.abandon(keeper_of_records_);
                }
                exit_status_ = decode<int>(message.bytes);
                return;
            default:
                refuse(message);
        }
    }

    [[noreturn]] static void refuse(const Message& message) {
        throw RunError(fmt::format("A worker cannot interpret message {}.", static_cast<int>(message.tag)));
    }

    Writer& expect_writer(const Message& message) {
        if (!writer_) refuse(message);
        return *writer_;
    }

    /// What failed is for the master, who may want it computed again.
    void note_answer(Answer answer) {
        const bool failed = answer.record.result.status != MemberStatus::done;
        if (failed && keeper_of_records_ != master_rank) {
            link_.send(master_rank, Tag::answer, encode(std::vector{std::move(answer)}));
        } else if (writer_) {
            writer_->keep(link_.rank(), std::move(answer));
        } else {
            if (answers_.empty()) first_answer_ = std::chrono::steady_clock::now();
            answers_.push_back(std::move(answer));
        }
    }

    /// Sends at once if a core would run out of work; otherwise several answers share a message.
    void send_answers() {
        if (answers_.empty()) return;
        const std::chrono::duration<double> held_back = std::chrono::steady_clock::now() - first_answer_;
        const bool waits = crew_.waiting() >= crew_.threads() && answers_.size() < most_held_back &&
                           held_back.count() < patience_.with_answers;
        if (waits) return;
        link_.send(keeper_of_records_, Tag::answer, encode(answers_));
        answers_.clear();
    }

    /// This rank can no longer compute: it leaves its members to the others.
    void give_up(const CrewTrouble& trouble) {
        fmt::print(stderr, "floes: rank {} leaves. {}\n", link_.rank(), trouble.sentence);
        if (trouble.stuck) {
            if (writer_) writer_->sync();
            std::_Exit(exit_stopped);
        }
        crew_.abandon();
        dismissed_ = true;
    }

    Link& link_;
    const Campaign& campaign_;
    Hand hand_;
    int keeper_of_records_;         // rank
    std::optional<Writer> writer_;  // if it is this one, and not the master
    const SilenceLimits& patience_;
    const StopSignals& signals_;
    Silence silence_{1, std::chrono::steady_clock::now()};  // of the master
    double next_sign_ = patience_.sign_of_life;             // of life, in time listened
    Crew crew_;
    Pause pause_ = pause_between_polls(2);
    std::vector<Answer> answers_;  // not sent yet
    std::chrono::steady_clock::time_point first_answer_;
    bool dismissed_ = false;
    bool ranks_are_missing_ = false;
    bool said_farewell_ = false;
    bool passed_signal_ = false;
    std::optional<int> exit_status_;
};

int serve(Link& link, const CrewSetup& setup, const SilenceLimits& patience, const StopSignals& signals) {
    Message first = wait_for_message(link);
    Post post;
    if (first.tag == Tag::post) {
        post = decode<Post>(first.bytes);
        first = wait_for_message(link);
    }
    if (first.tag == Tag::leave) return decode<int>(first.bytes);  // the run ended before it began
    if (first.tag != Tag::campaign) throw RunError("A worker must receive the campaign before anything else.");
    const Campaign campaign = read_campaign({decode<std::string>(first.bytes), "campaign of the master", {}}, no_file);
    return Worker(link, campaign, post, setup, patience, signals).run();
}

}  // namespace

int threads_of(const Link& link, int asked) {
    return asked > 0 ? asked : link.topology().cores;
}

int serve_campaign(Link& link, int threads, const MemberFunction& compute, Helper* helper,
                   const SilenceLimits& patience) {
    const StopSignals signals;
    try {
        return serve(link,
                     {.compute = compute, .threads = threads_of(link, threads), .helper = helper, .rank = link.rank()},
                     patience, signals);
    } catch (const std::exception& error) {
        link.send(master_rank, Tag::trouble, encode(std::string(error.what())));
    }
    while (true) {
        const Message message = wait_for_message(link);
        if (message.tag == Tag::leave) return decode<int>(message.bytes);
    }
}

}  // namespace floes
