#include "driver/messages.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "store/synthetic.hpp"

namespace floes {
namespace {

TEST(Messages, ComeBackAsTheyWere) {
    const Hello hello = decode_hello(encode(Hello{12, "node7", "abc"}));
    EXPECT_EQ(hello.cores, 12);
    EXPECT_EQ(hello.host, "node7");
    EXPECT_EQ(hello.fingerprint, "abc");
    const Assignment assignment = decode_assignment(encode(Assignment{1234, 5}));
    EXPECT_EQ(assignment.number, 1234);
    EXPECT_EQ(assignment.attempt, 5);
    EXPECT_EQ(decode_status(encode_status(85)), 85);
    EXPECT_EQ(decode_text(encode_text("Σ = 1")), "Σ = 1");
    const MemberRecord record = synthetic::record(synthetic::campaign(), 6);
    const Answer answer = decode_answer(encode(Answer{6, record}));
    EXPECT_EQ(answer.number, 6);
    EXPECT_EQ(encode(answer.record), encode(record));
}

TEST(Messages, AreRefusedWhenCutShort) {
    Bytes bytes = encode(Answer{6, synthetic::record(synthetic::campaign(), 6)});
    bytes.pop_back();
    EXPECT_THROW(decode_answer(bytes), RunError);
    EXPECT_THROW(decode_assignment({}), RunError);
}

}  // namespace
}  // namespace floes
