#include "stridor/hearing/heard_cases.hpp"

#include "stridor/base/error.hpp"
#include "support/expected_error.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <stop_token>

namespace stridor::hearing {
namespace {

using classification::Category;

TEST(HeardCases, AreThoseOfTable1EachPhaseAndTheWhole) {
    const std::vector<HeardCase> cases = hear_table_1({});
    ASSERT_EQ(cases.size(), 4U);
    EXPECT_EQ(cases[0].name, "squeal");
    EXPECT_EQ(cases[3].name, "quiet");
    for (const HeardCase& heard : cases) {
        ASSERT_EQ(heard.phases.size(), 2U) << heard.name;
        EXPECT_FALSE(heard.reason.empty()) << heard.name;
        // by ear as by contact states
        for (const HeardSound& phase : heard.phases)
            EXPECT_EQ(phase.heard, phase.cell.category) << heard.name;
    }
    EXPECT_EQ(cases[0].phases[0].heard, Category::squeal);
    EXPECT_EQ(cases[0].whole, Category::squeal);
    EXPECT_EQ(cases[3].whole, Category::none);
}

TEST(HeardCases, SayWhereTheyWereStopped) {
    std::stop_source stop;
    stop.request_stop();
    HearingOptions options;
    options.stop = stop.get_token();
    const std::optional<Error> thrown = support::error_of([&] { hear_table_1(options); });
    support::expect_error(thrown, "stopped in Table 1", "");
    EXPECT_EQ(thrown->kind(), ErrorKind::interrupted);
}

}  // namespace
}  // namespace stridor::hearing
