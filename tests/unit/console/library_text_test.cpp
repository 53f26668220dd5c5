#include "stridor/console/results/library_text.hpp"

#include "stridor/base/error.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace stridor::console {
namespace {

using noise_library::Entry;

std::vector<Entry> entries() {
    std::vector<Entry> all(2);
    all[0].id = 7;
    all[0].system = "seal";
    all[0].preload = 20.0;
    all[1].id = 12;
    all[1].system = "r\u00fcck";  // two bytes, one letter
    return all;
}

TEST(EntryTable, AlignsLettersAndPutsNumbersToTheRight) {
    ::setenv("NO_COLOR", "1", 1);
    EXPECT_EQ(entry_table(entries(), {"id", "preload", "system"}, {}),
              "id  preload  system\n"
              "          N\n"
              " 7       20  seal\n"
              "12           r\u00fcck\n");
}

TEST(EntryTable, RefusesWhatIsNoField) {
    EXPECT_THROW(entry_table(entries(), {"sistem"}, {}), Error);
}

TEST(SummaryText, CountsAndGivesReasons) {
    noise_library::Arrivals arrivals;
    arrivals.added = {1, 2};
    arrivals.known = {{"a.wav", 3}};
    arrivals.refused = {{"b.wav", "b.wav: it is broken"}};
    arrivals.left = 1;
    EXPECT_EQ(summary_text(arrivals),
              "added 2, known 1, refused 1, not looked at 1\nknown    a.wav: entry 3 has its sound\n"
              "refused  b.wav: it is broken");
}

TEST(FindingLines, NameEntriesAndSounds) {
    noise_library::Findings findings;
    EXPECT_TRUE(finding_lines(findings).empty());
    findings.saved.damages = {"page 3 is damaged"};
    EXPECT_EQ(finding_lines(findings), (std::vector<std::string>{"page 3 is damaged"}));
    EXPECT_EQ(ids_text({3}), "entry 3");
    EXPECT_EQ(ids_text({3, 5}), "entries 3, 5");
}

}  // namespace
}  // namespace stridor::console
