#include "core/contract.hpp"

#include <gtest/gtest.h>

namespace floes {
namespace contract_test {
namespace {

TEST(Contract, IsAskedOnlyWhereAssertionsAreOn) {
    int asked = 0;
    const auto broken = [&] { return ++asked < 0; };
#ifdef NDEBUG
    FLOES_EXPECTS(broken());
    FLOES_ENSURES(broken());
    EXPECT_EQ(asked, 0);
#else
    EXPECT_THROW(FLOES_EXPECTS(broken()), ContractError);
    EXPECT_THROW(FLOES_ENSURES(broken()), ContractError);
    EXPECT_EQ(asked, 2);
#endif
}

TEST(Contract, SaysWhatWasExpectedAndWhere) {
    try {
        contract_broken("expects", "step > 0", "oscillator.cpp", 57);
    } catch (const ContractError& error) {
        EXPECT_STREQ(error.what(), "oscillator.cpp:57: expects step > 0");
    }
}

}  // namespace
}  // namespace contract_test
}  // namespace floes
