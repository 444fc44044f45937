#pragma once
// Questions wait here for the one thread that answers them, so that each has all cores. Two alike are answered once.

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "serve/served_model.hpp"

namespace floes {

/// Called from any thread. Every call-back is called once: by answer(), or by close().
class QuestionQueue {
  public:
    using Tell = std::function<void(const ModelAnswer&)>;

    /// No more than `most` different questions wait, beside the one that is being answered.
    explicit QuestionQueue(std::size_t most) : most_(most) {}

    /// Lets the question wait. `tell` is called at once with the reason where it cannot.
    void add(const ModelQuestion& question, Tell tell);

    /// The question to be answered next, which counts as being answered from now on; none within `patience`.
    std::optional<ModelQuestion> next(std::chrono::milliseconds patience);

    /// Answers the question that next() gave.
    void answer(const ModelAnswer& answer);

    /// Answers all that wait, and all that come later, with `why`.
    void close(const ModelError& why);

    std::size_t waiting() const;

  private:
    struct Waiting {
        ModelQuestion question;
        std::vector<Tell> told;
    };

    std::optional<ModelError> take(const ModelQuestion& question, const Tell& tell);

    mutable std::mutex mutex_;
    std::condition_variable came_;
    std::size_t most_;
    std::deque<Waiting> waiting_;
    std::optional<Waiting> current_;
    std::optional<ModelError> closed_;
};

}  // namespace floes
