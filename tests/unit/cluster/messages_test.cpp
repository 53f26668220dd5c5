#include "stridor/cluster/messages.hpp"

#include "support/error_text.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <string>

namespace stridor::cluster {
namespace {

using support::thrown_by;

std::vector<Message> one_of_each() {
    return {Begin{"stridor 1", "abc", "n0"},
            Hello{"n1", 3},
            Batch{{{5, ""}, {std::size_t{1} << 31U, "of two"}}},
            Delivery{{{5, std::string("\0\1", 2)}, {7, ""}}, 0.25},
            Alive{},
            Stop{},
            Stopped{},
            Failure{ErrorKind::numerical, {"what", "why", "and now?"}},
            End{4},
            Bye{}};
}

TEST(Message, EachComesBackAsWhatItWas) {
    for (const Message& message : one_of_each()) {
        const Message received = unpack(pack(message));
        EXPECT_EQ(received.index(), message.index());
        EXPECT_EQ(pack(received), pack(message));
    }
    const auto failure = std::get<Failure>(unpack(pack(one_of_each()[7])));
    EXPECT_EQ(failure.kind, ErrorKind::numerical);
    EXPECT_EQ(failure.problem.suggestion, "and now?");
    const auto batch = std::get<Batch>(unpack(pack(one_of_each()[2])));
    EXPECT_EQ(batch.tasks.back().number, std::size_t{1} << 31U);
    EXPECT_EQ(batch.tasks.back().bytes, "of two");
    const auto results = std::get<Delivery>(unpack(pack(one_of_each()[3])));
    EXPECT_EQ(results.seconds_per_task, 0.25);
    EXPECT_EQ(results.results.front().bytes, std::string("\0\1", 2));
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
