#pragma once
// What is wrong with a configuration, gathered so that all of it is told at once. For this module only.

#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"

namespace floes {

/// All that is wrong with a configuration, each once, in the order in which it was found.
class Refusals {
  public:
    bool any() const { return !sentences_.empty(); }

    void add(std::string sentence) { add("", "", std::move(sentence)); }

    /// Of one case; what is wrong with several stands once.
    void add(const std::string& where, const std::string& label, std::string sentence) {
        if (!known_.insert(where + sentence).second) return;
        sentences_.push_back(where + label + sentence);
    }

    /// Keeps what `act` refuses.
    template <class Act>
    void gather(const Act& act) {
        try {
            act();
        } catch (const InputError& refused) {
            add(refused.what());
        }
    }

    /// Throws InputError where there is any, with a line for each.
    void refuse() const {
        constexpr std::size_t most = 20;
        if (!any()) return;
        std::string text(
            fmt::format("{}", fmt::join(std::span(sentences_).first(std::min(most, sentences_.size())), "\n")));
        if (sentences_.size() > most) text += fmt::format("\nand {} more", sentences_.size() - most);
        throw InputError(text);
    }

  private:
    std::vector<std::string> sentences_;
    std::set<std::string> known_;  ///< without the case
};

}  // namespace floes
