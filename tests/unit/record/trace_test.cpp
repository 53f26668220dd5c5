#include "stridor/record/trace.hpp"

#include <gtest/gtest.h>

#include <set>

namespace stridor::record {
namespace {

std::vector<std::string> names(const Trace& trace, const std::vector<std::string>& dofs) {
    std::vector<std::string> all;
    for (const NumberColumn& column : columns(trace, dofs))
        all.push_back(column.name);
    return all;
}

TEST(Columns, NameTheOnlyContactByNothing) {
    const Trace trace = empty_trace(1);
    EXPECT_EQ(names(trace, {"x"}),
              (std::vector<std::string>{"time", "displacement_x", "velocity_x", "acceleration_x", "surface_velocity",
                                        "normal_force", "friction_force", "gap"}));
}

TEST(Columns, NumberSeveralContacts) {
    const std::vector<std::string> all = names(empty_trace(2, 3), {"u1", "u2"});
    EXPECT_EQ(std::set(all.begin(), all.end()).size(), all.size());
    EXPECT_EQ(all.back(), "gap_3");
    EXPECT_EQ(all.size(), 2U + 3U * 2U + 3U * 3U);
}

TEST(Columns, PointToTheSamplesOfTheirContact) {
    Trace trace = empty_trace(1, 2);
    const std::array still{0.0};
    const std::array contacts{ContactSample{1.0, 2.0, 3.0}, ContactSample{4.0, 5.0, 6.0}};
    append(trace, {0.5, still, still, still, 0.1, contacts});
    const std::vector<std::string> dofs{"x"};
    std::vector<double> values;
    for (const NumberColumn& column : columns(trace, dofs))
        values.push_back(column.samples->at(0));
    EXPECT_EQ(values, (std::vector<double>{0.5, 0.0, 0.0, 0.0, 0.1, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0}));
    clear(trace);
    for (const NumberColumn& column : columns(trace, dofs))
        EXPECT_TRUE(column.samples->empty()) << column.name;
    EXPECT_TRUE(trace.contacts[1].state.empty());
}

}  // namespace
}  // namespace stridor::record
