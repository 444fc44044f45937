// Pieces of level ice in a frame: what has broken off, and the sheet.

#include <gtest/gtest.h>

#include "replay/recording.hpp"

namespace floes {
namespace pieces_test {

TEST(PiecesOfAFrame, AreTheSheetAndWhatBrokeOff) {
    Frame frame;
    frame.pieces = {7, 7, 2, 7, 2, 5};
    EXPECT_EQ(largest_piece(frame), 7);
    EXPECT_EQ(count_pieces(frame).all, 3);
    EXPECT_EQ(count_pieces(frame).broken, 2);
}

TEST(PiecesOfAFrame, OfOneSizeTheFirstIsTheSheet) {
    Frame frame;
    frame.pieces = {4, 1, 4, 1};
    EXPECT_EQ(largest_piece(frame), 1);
}

}  // namespace pieces_test
}  // namespace floes
