// Contacts in packs: side by side only what may be, one after the other what must be.

#include "solver/contact_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace floes::testing {
namespace contact_order_test {

using Contact = ContactOrder::Contact;

constexpr std::uint32_t spare = 100;
constexpr std::uint32_t wall = 99;

Contact touch(std::uint32_t a, std::uint32_t b, bool pressed = false) {
    return {a, b, a, b, a != wall, b != wall, pressed};
}

/// A chain along which each pair has to wait for the one before it, pairs that are free to go, and some on a wall.
std::vector<Contact> crowd() {
    std::vector<Contact> contacts;
    for (std::uint32_t i = 0; i < 9; ++i) {
        for (std::uint32_t k = 0; k <= i % 4; ++k) contacts.push_back(touch(i, i + 1, i % 3 == 0));
    }
    for (std::uint32_t i = 0; i < 23; ++i) {
        for (std::uint32_t k = 0; k <= (7 * i) % 4; ++k) contacts.push_back(touch(20 + 2 * i, 21 + 2 * i, i % 2 == 0));
    }
    for (std::uint32_t i = 0; i < 11; ++i) contacts.push_back(touch(20 + i, wall));
    return contacts;
}

class Packs : public ::testing::TestWithParam<std::pair<int, int>> {
  protected:
    Packs() { order.lay_out(contacts, spare, GetParam().first, GetParam().second); }

    /// `look(pack, its slots)`
    template <class Look>
    void for_each_pack(const Look& look) const {
        const std::uint32_t* slots = order.packs().slots;
        for (std::size_t i = 0; i < order.packs().count; ++i) {
            look(order.packs().packs[i], slots);
            slots += 2 * width * order.packs().packs[i].turns;
        }
    }

    std::vector<Contact> contacts = crowd();
    ContactOrder order;
    std::uint32_t width = static_cast<std::uint32_t>(GetParam().first);
};

TEST_P(Packs, NoMovingBodyTwiceInAPack) {
    for_each_pack([&](const ContactPack& pack, const std::uint32_t* slots) {
        std::multiset<std::uint32_t> all(slots, slots + 2 * width * pack.turns);
        for (const std::uint32_t slot : all) EXPECT_TRUE(slot == spare || slot == wall || all.count(slot) == 1) << slot;
    });
}

TEST_P(Packs, EveryContactHasARowInTheLaneOfItsBodies) {
    std::set<std::uint32_t> taken;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        EXPECT_TRUE(taken.insert(order.slot(i)).second);
        EXPECT_LT(order.slot(i), order.rows() * width);
        int found = 0;
        for_each_pack([&](const ContactPack& pack, const std::uint32_t* slots) {
            const std::uint32_t row = order.slot(i) / width;
            if (row < pack.first_row || row >= pack.end_row) return;
            const std::uint32_t turn = (row - pack.first_row) % pack.turns;
            const std::uint32_t* a = slots + 2 * width * turn + order.slot(i) % width;
            EXPECT_EQ(a[0], contacts[i].a);
            EXPECT_EQ(a[width], contacts[i].b);
            ++found;
        });
        EXPECT_EQ(found, 1);
    }
}

TEST_P(Packs, ContactsThatShareAMovingBodyKeepTheirOrder) {
    const auto shared = [](const Contact& x, const Contact& y) {
        return (x.a_moves && (x.a == y.a || x.a == y.b)) || (x.b_moves && (x.b == y.a || x.b == y.b));
    };
    for (std::size_t j = 0; j < contacts.size(); ++j) {
        for (std::size_t i = 0; i < j; ++i) {
            if (!shared(contacts[i], contacts[j])) continue;
            EXPECT_LT(order.slot(i) / width, order.slot(j) / width);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Widths, Packs,
                         ::testing::Values(std::pair{1, 1}, std::pair{2, 1}, std::pair{4, 1}, std::pair{4, 2},
                                           std::pair{8, 2}));

/// The contacts of each body, in the order in which they are solved.
std::vector<std::vector<std::size_t>> sequences(const std::vector<Contact>& contacts, int width) {
    ContactOrder order;
    order.lay_out(contacts, spare, width, 1, ContactOrder::Order::any);
    const auto row = [&](std::size_t i) { return order.slot(i) / static_cast<std::uint32_t>(width); };
    std::vector<std::vector<std::size_t>> found(spare);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        for (const std::uint32_t body : {contacts[i].a, contacts[i].b}) {
            if (body != wall) found[body].push_back(i);
        }
    }
    for (std::vector<std::size_t>& all : found) {
        std::ranges::sort(all, {}, row);
        for (std::size_t i = 1; i < all.size(); ++i) EXPECT_NE(row(all[i - 1]), row(all[i]));
    }
    return found;
}

TEST(ContactOrder, AnyOrderIsTheSameAtEveryWidthAndLeavesFewLanesEmpty) {
    const std::vector<Contact> contacts = crowd();
    for (const int width : {2, 4, 8}) EXPECT_EQ(sequences(contacts, width), sequences(contacts, 1)) << width;
    ContactOrder given;
    ContactOrder any;
    given.lay_out(contacts, spare, 8, 1);
    any.lay_out(contacts, spare, 8, 1, ContactOrder::Order::any);
    EXPECT_LT(any.rows(), given.rows());
}

TEST(ContactOrder, AnyOrderHasRoomForMoreNeighboursThanItCountsByBits) {
    std::vector<Contact> contacts;
    for (std::uint32_t i = 1; i < 90; ++i) contacts.push_back(touch(0, i));
    const std::vector<std::vector<std::size_t>> found = sequences(contacts, 8);
    EXPECT_EQ(found[0].size(), 89u);
}

TEST(ContactOrder, NoContactsNoRows) {
    ContactOrder order;
    order.lay_out({}, spare, 8, 2);
    EXPECT_EQ(order.packs().count, 0u);
    EXPECT_EQ(order.rows(), 0u);
}

TEST(ContactOrder, PairsThatBearNothingAreApartFromThoseThatDo) {
    std::vector<Contact> contacts;
    for (std::uint32_t i = 0; i < 16; ++i) contacts.push_back(touch(2 * i, 2 * i + 1, i % 2 == 0));
    ContactOrder order;
    order.lay_out(contacts, spare, 8, 1);
    ASSERT_EQ(order.packs().count, 2u);
    for (std::uint32_t i = 0; i < 16; ++i) EXPECT_EQ(order.slot(i) / 8, i % 2);
}

}  // namespace contact_order_test
}  // namespace floes::testing
