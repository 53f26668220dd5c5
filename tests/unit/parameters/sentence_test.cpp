#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/fields/sound_thresholds.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace stridor::parameters {
namespace {

// the first word of a sentence that is a name of the program's text; empty where there is none
std::string_view name_in(std::string_view sentence) {
    const std::size_t underscore = sentence.find('_');
    if (underscore == std::string_view::npos) return {};
    const std::size_t blank = sentence.rfind(' ', underscore);
    const std::size_t first = blank == std::string_view::npos ? 0 : blank + 1;
    return sentence.substr(first, sentence.find_first_of(" ,;.)", first) - first);
}

bool is_known_name(std::string_view word) {
    for (const Field& field : fields())
        if (field.name == word || field.symbol == word || key_of(field) == word) return true;
    return false;
}

TEST(Sentences, OfThresholdsAreWords) {
    for (const SoundThreshold& threshold : sound_thresholds())
        EXPECT_EQ(name_in(threshold.sentence), "") << threshold.name;
}

TEST(Sentences, OfFieldsNameKnownFieldsOnly) {
    for (const Field& field : fields()) {
        const std::string_view name = name_in(field.sentence);
        EXPECT_TRUE(name.empty() || is_known_name(name)) << key_of(field) << ": " << field.sentence;
    }
}

}  // namespace
}  // namespace stridor::parameters
