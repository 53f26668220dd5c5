#include "stridor/drawing/lettering.hpp"

#include "stridor/base/escapes.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace stridor::drawing {
namespace {

using namespace std::string_literals;

TEST(TextWidth, GrowsWithTheSizeAlone) {
    const StyledText text = StyledText("friction ") + symbol("mu_d") + StyledText(" [N]");
    // letters are not fitted to dots: sizes are counted in 1/1024 pt
    EXPECT_NEAR(text_width(text, 80.0), 10.0 * text_width(text, 8.0), 0.05);
}

TEST(TextWidth, IsThatOfTheLetters) {
    EXPECT_GT(text_width("WWWW", 8.0), 2.0 * text_width("iiii", 8.0));
    EXPECT_GT(text_width(StyledText("squeal", TextStyle::bold), 8.0), text_width("squeal", 8.0));
    EXPECT_LT(text_width(StyledText("exc", TextStyle::subscript), 8.0), 0.8 * text_width("exc", 8.0));
    EXPECT_EQ(text_width({}, 8.0), 0.0);
    EXPECT_NEAR(text_width("ẍ", 8.0), text_width("x", 8.0), 1e-9) << "an accent takes no room";
}

TEST(TextWidth, TakesMarkupLiterally) {
    EXPECT_GT(text_width("<b>a</b>", 8.0), 4.0 * text_width("a", 8.0));
    EXPECT_GT(text_width("&amp;", 8.0), 2.0 * text_width("&", 8.0));
}

TEST(Drawable, HasNeitherControlsNorBrokenBytes) {
    EXPECT_EQ(drawable("two\nlines\t\x7f"), "two lines  ");
    EXPECT_EQ(drawable("a\xff\xc3"), "a\uFFFD\uFFFD");
    EXPECT_EQ(drawable("a\0b"s), "a\uFFFDb");
    EXPECT_EQ(drawable("\uFFFE\uFFFF"), "\uFFFD\uFFFD") << "no XML may hold them";
    EXPECT_EQ(drawable("μ_d = 70°"), "μ_d = 70°");
}

RC_GTEST_PROP(Drawable, OfAnyBytesIsMeasured, ()) {
    const auto text = *rc::gen::arbitrary<std::string>();
    RC_ASSERT(base::is_utf8(drawable(text)));
    RC_ASSERT(text_width(text, 8.0) >= 0.0);
}

RC_GTEST_PROP(Wrapped, LosesNothingAndBreaksOnlyAtBlanks, ()) {
    const auto words = *rc::gen::container<std::vector<std::string>>(
        rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::inRange('a', 'z'))));
    std::string sentence;
    for (const std::string& word : words)
        sentence += (sentence.empty() ? "" : " ") + word;
    const double width = *support::number_between(5.0, 60.0);
    std::string joined;
    for (const StyledText& line : wrapped(sentence, 8.0, width)) {
        const std::string characters = plain_text(line);
        const bool is_one_word = std::count(characters.begin(), characters.end(), ' ') <= 1;
        RC_ASSERT(text_width(line, 8.0) <= width || is_one_word);
        joined += characters;
    }
    RC_ASSERT(joined == sentence);
}

}  // namespace
}  // namespace stridor::drawing
