// Every reader of what others made meets each change of a valid example: what must not matter gives the same numbers to
// rounding, what must be refused is refused in one sentence with the file's name. docs/trust.md has what none can tell.

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "readers/example.hpp"

namespace floes {
namespace readers_test {

using test::Change;
using test::Example;
using test::Numbers;

const std::vector<Example>& examples() {
    static const std::vector<Example> all = [] {
        std::vector<Example> found = test::hydrodynamic_examples();
        for (const auto& more : {test::shape_examples(), test::table_examples()})
            found.insert(found.end(), more.begin(), more.end());
        return found;
    }();
    return all;
}

/// Sorted numbers, or the sentence by which the text is refused. Anything else that is thrown fails the test.
std::variant<Numbers, std::string> answer(const Example& example, const std::string& text) {
    try {
        Numbers numbers = example.read(text);
        std::ranges::sort(numbers);
        return numbers;
    } catch (const InputError& error) {
        return std::string(error.what());
    }
}

bool same(const Numbers& one, const Numbers& other) {
    return std::ranges::equal(one, other, [](double a, double b) {
        return std::abs(a - b) <= 1e-9 * std::max(1.0, std::max(std::abs(a), std::abs(b)));
    });
}

/// What is wrong with a refusal; empty: nothing.
std::string fault_of(const std::string& refusal, const Example& example) {
    constexpr std::size_t longest = 400;
    if (refusal.size() > longest) return "is longer than a sentence";
    if (refusal.find('\n') != std::string::npos) return "is more than a line";
    // What contradicts a configuration may be refused there.
    if (refusal.find(example.file) == std::string::npos && refusal.find("my.toml") == std::string::npos)
        return "does not name the file";
    return "";
}

struct Count {
    int same = 0;
    int refused = 0;
    int other = 0;        ///< other numbers, without a word
    std::string shown{};  ///< of the last that was other, or refused
    std::string bad_refusal{};
};

Count counted(const Example& example, const Change& change, const Numbers& original) {
    Count count;
    for (const std::string& text : change.variants(example)) {
        const auto said = answer(example, text);
        if (const auto* refusal = std::get_if<std::string>(&said)) {
            ++count.refused;
            const std::string fault = fault_of(*refusal, example);
            if (!fault.empty()) count.bad_refusal = fmt::format("\"{}\" {}:\n{}", *refusal, fault, text);
            if (count.other == 0) count.shown = *refusal;
        } else if (same(std::get<Numbers>(said), original)) {
            ++count.same;
        } else {
            ++count.other;
            count.shown = fmt::format("other numbers ({}; {} before) of:\n{}", fmt::join(std::get<Numbers>(said), " "),
                                      fmt::join(original, " "), text);
        }
    }
    return count;
}

class Readers : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(Readers, GiveTheSameOrRefuse) {
    const Example& example = examples().at(static_cast<std::size_t>(GetParam().first));
    const Change& change = test::all_changes[GetParam().second];
    const auto original = answer(example, test::text_of(example.lines));
    ASSERT_TRUE(std::holds_alternative<Numbers>(original)) << std::get<std::string>(original);
    const Numbers& numbers = std::get<Numbers>(original);
    ASSERT_FALSE(numbers.empty());
    const Count count = counted(example, change, numbers);
    EXPECT_EQ(count.bad_refusal, "");
    ASSERT_GT(count.same + count.refused + count.other, 0);
    switch (example.outcomes.at(static_cast<std::size_t>(GetParam().second))) {
        case '=':
            EXPECT_EQ(count.refused + count.other, 0) << count.shown;
            break;
        case 'x':
            // A file that is cut where nothing followed is whole.
            EXPECT_EQ(count.other, 0) << count.shown;
            EXPECT_GT(count.refused, 0) << "nothing was refused";
            break;
        case '?':
            EXPECT_GT(count.other, 0) << "can be told: " << count.shown;
            break;
        default:
            ADD_FAILURE() << "no such outcome";
    }
}

std::vector<std::pair<int, int>> pairs() {
    std::vector<std::pair<int, int>> all;
    for (int example = 0; example < std::ssize(examples()); ++example)
        for (int change = 0; change < std::ssize(test::all_changes); ++change)
            if (examples()[static_cast<std::size_t>(example)].outcomes.at(static_cast<std::size_t>(change)) != '-')
                all.emplace_back(example, change);
    return all;
}

std::string word(std::string text) {
    for (char& letter : text)
        if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
    return text;
}

INSTANTIATE_TEST_SUITE_P(All, Readers, testing::ValuesIn(pairs()), [](const auto& one) {
    return word(examples()[static_cast<std::size_t>(one.param.first)].name + "_" +
                test::all_changes[one.param.second].name);
});

TEST(Examples, HaveAnOutcomeForEachChange) {
    for (const Example& example : examples())
        EXPECT_EQ(example.outcomes.size(), std::size(test::all_changes)) << example.name;
}

}  // namespace readers_test
}  // namespace floes
