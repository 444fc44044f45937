#include "serve/served_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace floes {
namespace question_queue_test {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

/// Notes answers: the first mean, or the sentence.
class Notes {
  public:
    QuestionQueue::Tell next() {
        return [this](const ModelAnswer& answer) {
            const auto* error = std::get_if<ModelError>(&answer);
            said.emplace_back(error != nullptr
                                  ? error->what()
                                  : std::to_string(static_cast<int>(std::get<ModelValues>(answer).means[0])));
        };
    }

    std::vector<std::string> said;
};

ModelValues value(double mean) {
    return {{mean}, {0}};
}

TEST(QuestionQueue, AnswersInOrder) {
    QuestionQueue queue(5);
    Notes notes;
    queue.add({{1}}, notes.next());
    queue.add({{2}}, notes.next());
    EXPECT_EQ(queue.waiting(), 2u);
    const std::optional<AskedQuestion> one = queue.next(0ms);
    EXPECT_EQ(one->question.values, std::vector{1.0});
    queue.answer(one->turn, value(10));
    const std::optional<AskedQuestion> two = queue.next(0ms);
    EXPECT_EQ(two->question.values, std::vector{2.0});
    EXPECT_GT(two->turn, one->turn);
    queue.answer(two->turn, value(20));
    EXPECT_FALSE(queue.next(1ms));
    EXPECT_THAT(notes.said, ElementsAre("10", "20"));
}

TEST(QuestionQueue, GivesSeveralAtOnce) {
    QuestionQueue queue(1);
    Notes notes;
    std::vector<AskedQuestion> asked;
    for (const double number : {1.0, 2.0, 3.0}) {
        queue.add({{number}}, notes.next());
        asked.push_back(queue.next(0ms).value());
    }
    queue.add({{2}}, notes.next());  // is being answered, as the second of them
    EXPECT_EQ(queue.waiting(), 0u);
    queue.answer(asked[1].turn, value(20));
    EXPECT_THAT(notes.said, ElementsAre("20", "20"));
    queue.answer(asked[2].turn, value(30));
    queue.close(ModelError(ModelError::Kind::unavailable, "over"));
    EXPECT_THAT(notes.said, ElementsAre("20", "20", "30", "over"));
}

TEST(QuestionQueue, AnswersTwoAlikeOnce) {
    QuestionQueue queue(1);
    Notes notes;
    queue.add({{1}}, notes.next());
    queue.add({{1}, {}, {}, true}, notes.next());  // waits with the other, beyond the one place
    queue.add({{1}, 4}, notes.next());             // another number of arrangements is another question
    EXPECT_THAT(notes.said, ElementsAre(HasSubstr("No more than 1 evaluation may wait")));
    const std::optional<AskedQuestion> asked = queue.next(0ms);
    ASSERT_TRUE(asked);
    queue.add({{1}}, notes.next());  // while it is being answered
    EXPECT_EQ(queue.waiting(), 0u);
    queue.answer(asked->turn, value(10));
    EXPECT_EQ(notes.said.size(), 4u);
    EXPECT_EQ(notes.said.back(), "10");
    EXPECT_FALSE(queue.next(0ms));
}

TEST(QuestionQueue, RefusesMoreThanMayWait) {
    QuestionQueue queue(2);
    Notes notes;
    queue.add({{1}}, notes.next());
    ASSERT_TRUE(queue.next(0ms));  // no longer waits
    queue.add({{2}}, notes.next());
    queue.add({{3}}, notes.next());
    EXPECT_TRUE(notes.said.empty());
    queue.add({{4}}, notes.next());
    EXPECT_THAT(notes.said, ElementsAre(HasSubstr("No more than 2 evaluations may wait; ask again later")));
}

TEST(QuestionQueue, TellsAllWhenItCloses) {
    QuestionQueue queue(5);
    Notes notes;
    queue.add({{1}}, notes.next());
    queue.add({{2}}, notes.next());
    ASSERT_TRUE(queue.next(0ms));
    queue.close(ModelError(ModelError::Kind::unavailable, "over"));
    queue.add({{3}}, notes.next());
    EXPECT_THAT(notes.said, ElementsAre("over", "over", "over"));
}

TEST(QuestionQueue, WakesWhoWaits) {
    QuestionQueue queue(5);
    Notes notes;
    std::jthread asks([&] {
        std::this_thread::sleep_for(20ms);
        queue.add({{1}}, notes.next());
    });
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE(queue.next(20s));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s);
}

}  // namespace question_queue_test
}  // namespace floes
