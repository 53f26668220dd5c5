#include "stridor/cluster/messages.hpp"

#include "support/error_text.hpp"
#include "support/property.hpp"
#include "unit/cluster/invented_crew.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace stridor::cluster {
namespace {

using support::thrown_by;

std::vector<Message> one_of_each() {
    const Study study = invented_study(9, 0);
    std::vector<IndexedCell> cells;
    for (const std::size_t index : {0U, 17U, 62U})
        cells.push_back({index, invented_cell(study, index)});
    sweep::set_figure(cells[0].cell, sweep::cell_figures()[2], -0.0);
    sweep::set_figure(cells[0].cell, sweep::cell_figures()[3], std::numeric_limits<double>::quiet_NaN());
    cells[1].cell.starts = {{sweep::Status::done, classification::Category::creak}, {sweep::Status::failed, {}}};
    cells[1].cell.agreement = sweep::Agreement::differ;
    return {Hello{"stridor 1", "abc", "n1", 3},
            Batch{{5, 6, std::size_t{1} << 31U}},
            Cells{cells, 0.25},
            Alive{},
            Stop{},
            Stopped{},
            Failure{ErrorKind::numerical, {"what", "why", "and now?"}},
            End{4},
            Bye{}};
}

TEST(Message, CellsComeBackBitForBit) {
    const Message sent = one_of_each()[2];
    const auto received = std::get<Cells>(unpack(pack(sent)));
    const auto& cells = std::get<Cells>(sent).cells;
    ASSERT_EQ(received.cells.size(), cells.size());
    EXPECT_EQ(received.seconds_per_run, 0.25);
    for (std::size_t k = 0; k < cells.size(); ++k) {
        EXPECT_EQ(received.cells[k].index, cells[k].index);
        EXPECT_TRUE(sweep::same_cell(received.cells[k].cell, cells[k].cell)) << k;
    }
}

TEST(Message, EachComesBackAsWhatItWas) {
    for (const Message& message : one_of_each()) {
        const Message received = unpack(pack(message));
        EXPECT_EQ(received.index(), message.index());
        EXPECT_EQ(pack(received), pack(message));
    }
    const auto failure = std::get<Failure>(unpack(pack(one_of_each()[6])));
    EXPECT_EQ(failure.kind, ErrorKind::numerical);
    EXPECT_EQ(failure.problem.suggestion, "and now?");
    EXPECT_EQ(std::get<Batch>(unpack(pack(one_of_each()[1]))).runs.back(), std::size_t{1} << 31U);
}

TEST(Message, IsRefusedWhereItIsTornOrTooLong) {
    for (const Message& message : one_of_each()) {
        const std::string bytes = pack(message);
        for (std::size_t size = 0; size < bytes.size(); ++size)
            EXPECT_EQ(thrown_by([&] { unpack(bytes.substr(0, size)); }).kind, ErrorKind::io) << size;
        EXPECT_TRUE(thrown_by([&] { unpack(bytes + "x"); }).says("damaged"));
    }
}

// whatever the bytes: an error or a message, and no more memory than they could fill
RC_GTEST_PROP(Message, OfAnyBytesIsRefusedOrRead, (std::string bytes)) {
    try {
        const Message message = unpack(bytes);
        RC_ASSERT(pack(message) == bytes);
    } catch (const Error& error) {
        RC_ASSERT(error.kind() == ErrorKind::io);
    }
}

}  // namespace
}  // namespace stridor::cluster
