// The code of the worked example "A friction law" in docs/extending.md is the program's own.

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace stridor::model {
namespace {

std::string text_of(const std::string& path) {
    std::ifstream file(STRIDOR_SOURCE_DIR "/" + path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// lines without their indentation, empty ones left out
std::string unindented(const std::string& text) {
    std::istringstream lines(text);
    std::string result;
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t from = line.find_first_not_of(' '); from != std::string::npos)
            result += line.substr(from) + "\n";
    return result;
}

std::vector<std::string> blocks_of(const std::string& section) {
    std::vector<std::string> blocks;
    const std::string open = "```cpp\n", close = "```";
    for (std::size_t from = section.find(open); from != std::string::npos; from = section.find(open, from)) {
        from += open.size();
        blocks.push_back(unindented(section.substr(from, section.find(close, from) - from)));
    }
    return blocks;
}

TEST(WorkedExample, OfAFrictionLawIsTheCodeThatIsCompiled) {
    const std::string page = text_of("docs/extending.md");
    const std::size_t from = page.find("## A friction law"), to = page.find("## A law of impacts");
    ASSERT_LT(from, to);
    std::string code;
    for (const char* file :
         {"model/laws/friction.hpp", "model/laws/friction.cpp", "parameters/case.hpp", "parameters/fields/field.cpp"})
        code += unindented(text_of(std::string("src/stridor/") + file));
    const std::vector<std::string> blocks = blocks_of(page.substr(from, to - from));
    EXPECT_EQ(blocks.size(), 4U);
    for (const std::string& block : blocks)
        EXPECT_NE(code.find(block), std::string::npos) << block;
}

}  // namespace
}  // namespace stridor::model
