#include "stridor/base/field_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

namespace stridor::base {
namespace {

struct Row {
    std::string_view name;
};

constexpr std::array rows{Row{"mass"}, Row{"preload"}};
constexpr std::array<std::string_view, 2> engines{"exact", "beta_2"};
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(FindNamed, FindsTheRowOfAName) {
    EXPECT_EQ(find_named(rows, "preload"), &rows[1]);
    EXPECT_EQ(find_named(rows, "load"), nullptr);
}

TEST(DidYouMean, NamesWhatIsNearAndElseWhatItIsTold) {
    EXPECT_EQ(did_you_mean("exakt", engines), "Did you mean \"exact\"?");
    EXPECT_EQ(did_you_mean("runge-kutta", engines), "");
    EXPECT_EQ(did_you_mean("runge-kutta", engines, "See the manual."), "See the manual.");
    const std::array<std::string, 1> owned{"preload"};
    EXPECT_EQ(did_you_mean("preloda", owned), "Did you mean \"preload\"?");
}

TEST(PlaceOfChoice, IsThatAmongTheNames) {
    EXPECT_EQ(place_of_choice("run.engine", "beta_2", engines), 1U);
}

TEST(PlaceOfChoice, RefusesAnyOtherWithAllThatThereAre) {
    try {
        place_of_choice("run.engine", "exakt", engines, Place{"case.toml", 3, 0, ""});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        EXPECT_EQ(std::string(error.what()),
                  "run.engine = \"exakt\" is not one of its choices (choices: \"exact\", \"beta_2\"). Did you mean "
                  "\"exact\"? [case.toml:3]");
    }
}

TEST(QuantityText, HasTheUnitButOfAPureNumber) {
    EXPECT_EQ(quantity_text(20.0, "N"), "20 N");
    EXPECT_EQ(quantity_text(0.6, "1"), "0.6");
}

TEST(LimitsText, SaysWhatAValueMustBe) {
    EXPECT_EQ(limits_text(0.0, infinity, "kg", LowEnd::open), "above 0 kg");
    EXPECT_EQ(limits_text(0.0, infinity, "N"), "at least 0 N");
    EXPECT_EQ(limits_text(0.0, 100.0, "%"), "between 0 and 100 %");
    EXPECT_EQ(limits_text(0.5, 1.0, "1"), "between 0.5 and 1");
    EXPECT_EQ(limits_text(-infinity, infinity, "m/s"), "finite");
}

}  // namespace
}  // namespace stridor::base
