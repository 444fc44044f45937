#include "cli/answer.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace floes {
namespace waiting_note_test {

using std::chrono::milliseconds;

TEST(WaitingNote, SpeaksOnceWhenItIsOver) {
    std::ostringstream out;
    {
        const WaitingNote patience(out, "counting sand", milliseconds(1));
        std::this_thread::sleep_for(milliseconds(100));
    }
    EXPECT_EQ(out.str(), "floes: counting sand\n");
}

TEST(WaitingNote, SaysNothingOfWhatIsQuick) {
    std::ostringstream out;
    { const WaitingNote patience(out, "counting sand", std::chrono::hours(1)); }
    EXPECT_EQ(out.str(), "");
}

}  // namespace waiting_note_test
}  // namespace floes
