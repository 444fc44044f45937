#include "run/messages.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/synthetic.hpp"

namespace floes {
namespace messages_test {

TEST(Messages, ComeBackAsTheyWere) {
    const Hello hello = decode<Hello>(encode(Hello{12, "node7", "abc"}));
    EXPECT_EQ(hello.cores, 12);
    EXPECT_EQ(hello.host, "node7");
    EXPECT_EQ(hello.fingerprint, "abc");
    const auto assignments =
        decode<std::vector<Assignment>>(encode(std::vector<Assignment>{{1234, 5}, {1235, 1, true}}));
    ASSERT_EQ(assignments.size(), 2u);
    EXPECT_EQ(assignments[0].number, 1234);
    EXPECT_EQ(assignments[0].attempt, 5);
    EXPECT_FALSE(assignments[0].apart);
    EXPECT_TRUE(assignments[1].apart);
    EXPECT_EQ(decode<int>(encode(85)), 85);
    EXPECT_EQ(decode<std::string>(encode(std::string("Σ = 1"))), "Σ = 1");
    const MemberRecord record = synthetic::record(synthetic::campaign(), 6);
    const auto answers = decode<std::vector<Answer>>(encode(std::vector<Answer>{{6, record}, {7, record}}));
    ASSERT_EQ(answers.size(), 2u);
    EXPECT_EQ(answers[0].number, 6);
    EXPECT_EQ(answers[1].number, 7);
    EXPECT_EQ(encode(answers[1].record), encode(record));
    const Post post = decode<Post>(encode(Post{64, "/a/b.journal.1"}));
    EXPECT_EQ(post.writer, 64);
    EXPECT_EQ(post.journal, "/a/b.journal.1");
    const MemberNote note{.wall_time = 0.5, .arrangement = 2, .attempt = 2, .found = {3, 4, 5}};
    const auto kept =
        decode<std::vector<Kept>>(encode(std::vector<Kept>{{3, 6, note, {100, 200, 1}, {}}, {4, 7, {}, {}, record}}));
    ASSERT_EQ(kept.size(), 2u);
    EXPECT_EQ(kept[0].worker, 3);
    EXPECT_EQ(kept[0].number, 6);
    EXPECT_EQ(kept[0].note.attempt, 2);
    EXPECT_EQ(kept[0].note.arrangement, 2);
    EXPECT_EQ(kept[0].note.wall_time, 0.5);
    EXPECT_EQ(kept[0].note.found, note.found);
    EXPECT_TRUE(kept[0].note.done());
    EXPECT_EQ(kept[0].place.offset, 100u);
    EXPECT_EQ(kept[0].place.size, 200u);
    EXPECT_EQ(kept[0].place.piece, 1);
    EXPECT_FALSE(kept[0].record);
    EXPECT_EQ(encode(*kept[1].record), encode(record));
    const auto progress =
        decode<std::vector<MemberProgress>>(encode(std::vector<MemberProgress>{{3, 43.5, 200}, {4, 0.25, 100}}));
    ASSERT_EQ(progress.size(), 2u);
    EXPECT_EQ(progress[0].number, 3);
    EXPECT_EQ(progress[0].time, 43.5);
    EXPECT_EQ(progress[1].end, 100);
}

TEST(Messages, AreRefusedWhenCutShort) {
    Bytes bytes = encode(std::vector<Answer>{{6, synthetic::record(synthetic::campaign(), 6)}});
    bytes.pop_back();
    EXPECT_THROW(decode<std::vector<Answer>>(bytes), RunError);
    EXPECT_THROW(decode<std::vector<Assignment>>({}), RunError);
}

TEST(Messages, AreRefusedWhenTheyAreMoreThanTheySay) {
    const auto longer = [](Bytes bytes) {
        bytes.push_back(std::byte{0});
        return bytes;
    };
    EXPECT_THROW(decode<Hello>(longer(encode(Hello{}))), RunError);
    EXPECT_THROW(decode<std::vector<Assignment>>(longer(encode(std::vector<Assignment>{{1, 1}}))), RunError);
    EXPECT_THROW(decode<std::vector<Answer>>(longer(encode(std::vector<Answer>{}))), RunError);
    EXPECT_THROW(decode<Post>(longer(encode(Post{}))), RunError);
    EXPECT_THROW(decode<std::vector<Kept>>(longer(encode(std::vector<Kept>{}))), RunError);
    EXPECT_THROW(decode<std::vector<MemberProgress>>(longer(encode(std::vector<MemberProgress>{}))), RunError);
    EXPECT_THROW(decode<int>(longer(encode(0))), RunError);
    EXPECT_THROW(decode<std::string>(longer(encode(std::string("a")))), RunError);
    Bytes neither = encode(std::vector<Assignment>{{1, 1}});
    neither.back() = std::byte{2};
    EXPECT_THROW(decode<std::vector<Assignment>>(neither), RunError);
}

}  // namespace messages_test
}  // namespace floes
