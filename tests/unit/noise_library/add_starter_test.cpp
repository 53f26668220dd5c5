#include "stridor/noise_library/starter/add_starter.hpp"

#include "stridor/noise_library/starter/starter_noises.hpp"
#include "support/error_text.hpp"
#include "unit/noise_library/library_folder.hpp"

#include <gtest/gtest.h>

namespace stridor::noise_library {
namespace {

StarterAdding starter_adding() {
    StarterAdding adding;
    adding.probe = [](const std::filesystem::path&, Entry&) {};
    adding.case_text = [](const parameters::Case& c) { return c.title; };
    return adding;
}

// the run is stopped behind its first noise, and goes on there
TEST_F(LibraryFile, TakesStarterNoisesOnceAndGoesOnAfterAStop) {
    Library library = open();
    const std::size_t all = starter_noises().size();
    std::stop_source source;
    StarterAdding first = starter_adding();
    first.stop = source.get_token();
    first.added = [&](const Entry&) { source.request_stop(); };
    const Added stopped = add_starter(library, first);
    EXPECT_EQ(support::thrown_by([&] { std::rethrow_exception(stopped.ended_by); }).kind, ErrorKind::interrupted);
    EXPECT_EQ(stopped.arrivals.added.size(), 1U);
    EXPECT_EQ(stopped.arrivals.left, all - 1);
    const Entry entry = library.get(stopped.arrivals.added).front();
    EXPECT_EQ(entry.recorded, "simulation");
    EXPECT_EQ(entry.case_text, starter_noises().front().c.title);

    source = {};
    first.stop = source.get_token();
    const Added again = add_starter(library, first);
    EXPECT_EQ(again.arrivals.known.size(), 1U);
    EXPECT_EQ(again.arrivals.added.size(), 1U);
}

}  // namespace
}  // namespace stridor::noise_library
