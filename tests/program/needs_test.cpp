#include "support/needs.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace {

/// The environment variable CI, as it was again at the end.
class Ci {
public:
    explicit Ci(const char* value) {
        if (const char* before = std::getenv("CI")) before_ = before;
        set(value);
    }
    ~Ci() { set(before_ ? before_->c_str() : nullptr); }
    Ci(const Ci&) = delete;
    Ci& operator=(const Ci&) = delete;

private:
    static void set(const char* value) {
        if (value != nullptr)
            setenv("CI", value, 1);
        else
            unsetenv("CI");
    }

    std::optional<std::string> before_;
};

void need_a_piano(bool is_there) {
    STRIDOR_NEEDS(is_there, "A piano", "piano");
}

/// What a test that needs a piano comes to: "tested", or how it ends and why.
std::string outcome(bool is_there, const char* ci) {
    const Ci environment(ci);
    testing::TestPartResultArray results;
    {
        const testing::ScopedFakeTestPartResultReporter reporter(&results);
        need_a_piano(is_there);
    }
    if (results.size() == 0) return "tested";
    const testing::TestPartResult& result = results.GetTestPartResult(0);
    return std::string(result.fatally_failed() ? "failed"
                       : result.skipped()      ? "left out"
                                               : "else") +
           ": " + result.message();
}

TEST(Needs, WhatIsThereIsTested) {
    EXPECT_EQ(outcome(true, nullptr), "tested");
    EXPECT_EQ(outcome(true, "true"), "tested");
}

TEST(Needs, WhatIsLackingIsLeftOutWithWhatToInstall) {
    const std::string said = outcome(false, nullptr);
    EXPECT_TRUE(said.starts_with("left out")) << said;
    EXPECT_NE(said.find("apt-get install piano"), std::string::npos) << said;
}

TEST(Needs, WhatIsLackingFailsInContinuousIntegration) {
    const std::string said = outcome(false, "true");
    EXPECT_TRUE(said.starts_with("failed")) << said;
    EXPECT_NE(said.find("apt-get install piano"), std::string::npos) << said;
}

}  // namespace
