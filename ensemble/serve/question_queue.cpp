#include "serve/question_queue.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/text.hpp"

namespace floes {

void QuestionQueue::add(const ModelQuestion& question, Tell tell) {
    if (const std::optional<ModelError> refusal = take(question, tell)) tell(*refusal);
}

std::optional<ModelError> QuestionQueue::take(const ModelQuestion& question, const Tell& tell) {
    const std::scoped_lock lock(mutex_);
    if (closed_) return closed_;
    if (current_ && current_->question.same_point(question)) {
        current_->told.push_back(tell);
        return std::nullopt;
    }
    const auto same =
        std::ranges::find_if(waiting_, [&](const Waiting& one) { return one.question.same_point(question); });
    if (same != waiting_.end()) {
        same->told.push_back(tell);
        return std::nullopt;
    }
    if (waiting_.size() >= most_)
        return ModelError(
            ModelError::Kind::unavailable,
            fmt::format("No more than {} may wait; ask again later, or start the server with a larger --waiting",
                        counted(std::ssize(waiting_), "evaluation")));
    waiting_.push_back({question, {tell}});
    came_.notify_one();
    return std::nullopt;
}

std::optional<ModelQuestion> QuestionQueue::next(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    FLOES_EXPECTS(!current_);
    if (!came_.wait_for(lock, patience, [&] { return !waiting_.empty(); })) return std::nullopt;
    current_ = std::move(waiting_.front());
    waiting_.pop_front();
    return current_->question;
}

void QuestionQueue::answer(const ModelAnswer& answer) {
    std::optional<Waiting> answered;
    {
        const std::scoped_lock lock(mutex_);
        answered = std::exchange(current_, std::nullopt);
    }
    FLOES_EXPECTS(answered.has_value());
    for (const Tell& tell : answered->told) tell(answer);
}

void QuestionQueue::close(const ModelError& why) {
    std::deque<Waiting> all;
    {
        const std::scoped_lock lock(mutex_);
        closed_ = why;
        all = std::exchange(waiting_, {});
        if (current_) all.push_back(*std::exchange(current_, std::nullopt));
    }
    for (const Waiting& one : all)
        for (const Tell& tell : one.told) tell(why);
}

std::size_t QuestionQueue::waiting() const {
    const std::scoped_lock lock(mutex_);
    return waiting_.size();
}

}  // namespace floes
