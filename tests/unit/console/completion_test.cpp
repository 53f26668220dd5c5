#include "stridor/console/completion.hpp"

#include <gtest/gtest.h>

namespace stridor::console {
namespace {

TEST(BashCompletion, KnowsCommandsTheirOptionsAndSubcommands) {
    const std::string script =
        bash_completion({{"simulate", {"--json", "--set"}, {}}, {"library", {}, {{"list", {"--where"}, {}}}}});
    const auto has = [&](const std::string& text) { return script.find(text) != std::string::npos; };
    EXPECT_TRUE(has("compgen -W \"simulate library help --help --version\""));
    EXPECT_TRUE(has("simulate) options=\"--json --set\" ;;"));
    EXPECT_TRUE(has("if [[ ${COMP_WORDS[1]} == library ]]; then"));
    EXPECT_TRUE(has("list) options=\"--where\" ;;"));
    EXPECT_FALSE(has("== simulate ]]; then"));
    EXPECT_TRUE(has("contact.preload="));
    EXPECT_TRUE(has("noise-chart rate-map weatherstrip"));
}

}  // namespace
}  // namespace stridor::console
