#include "stridor/report/verdict_words.hpp"

#include <gtest/gtest.h>

namespace stridor::report {
namespace {

using classification::Category;
using classification::Verdict;

Verdict verdict(record::Phase phase, Category category) {
    Verdict result;
    result.category = category;
    result.evidence.phase = phase;
    result.evidence.judged_rates = {0.25, 0.5, 0.25};
    result.evidence.alternation.frequency = 428.4;
    if (category == Category::none) result.quiet = classification::Quiet::slides;
    return result;
}

TEST(VerdictWords, SayWhatHappensAndHowOften) {
    const std::string words = plain_words(verdict(record::Phase::going, Category::squeal));
    EXPECT_NE(words.find("While the surface is going (V > 0) the contact squeals"), std::string::npos) << words;
    EXPECT_NE(words.find("about 428 times a second"), std::string::npos) << words;
    EXPECT_NE(words.find("sticks 50"), std::string::npos) << words;
}

TEST(VerdictWords, TellTheTwoKindsOfSilenceApart) {
    Verdict quiet = verdict(record::Phase::all, Category::none);
    EXPECT_NE(plain_words(quiet).find("slides steadily"), std::string::npos);
    quiet.quiet = classification::Quiet::sticks;
    EXPECT_NE(plain_words(quiet).find("is carried along"), std::string::npos);
}

TEST(VerdictWords, DoNotDecideWhatIsUndecided) {
    Verdict thin = verdict(record::Phase::all, Category::undecided);
    thin.reasons = {"fewer intervals than 6"};
    EXPECT_NE(plain_words(thin).find("there is no verdict: fewer intervals than 6"), std::string::npos);
}

}  // namespace
}  // namespace stridor::report
