#include "stridor/explorer/browser.hpp"

#include "stridor/base/error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace stridor::explorer {
namespace {

const std::string state = "preset=squeal&contact.preload=35&x=contact.preload:1:80:64:linear";

std::string refusal(const std::string& link) {
    try {
        return "taken: " + fragment_of(link);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        return error.problem().what;
    }
}

TEST(Link, IsToldFromTheNameOfAFile) {
    for (const char* text : {"http://localhost:8080/#preset=squeal", "https://a/#x", "#preset=squeal"})
        EXPECT_TRUE(is_link(text)) << text;
    for (const char* text : {"case.toml", "-", "", "http", "a#b.toml", "./#odd.toml"})
        EXPECT_FALSE(is_link(text)) << text;
}

TEST(Link, GivesThePagesState) {
    EXPECT_EQ(fragment_of("http://localhost:8080/#" + state), state);
    EXPECT_EQ(fragment_of("#" + state), state);
    EXPECT_EQ(fragment_of("#figure=frequency&preset=creak"), "figure=frequency&preset=creak");
}

TEST(Link, IsRefusedWhereNoPageMadeIt) {
    EXPECT_EQ(refusal("http://localhost:8080/"), "the link holds no case");
    EXPECT_EQ(refusal("#"), "the link holds no case");
    EXPECT_EQ(refusal("#x=preset=squeal"), "the link holds no case");
    EXPECT_EQ(refusal("#" + state + "&y=" + std::string(8000, '1')), "the link is too long");
    // a terminal, a shell and a page would each make something of these
    for (const char byte : {' ', '\n', '\r', '\x1b', '\x7f', '"', '<', '>', '`', '\\', '^', '\xc3', '#'})
        EXPECT_EQ(refusal("#" + state + byte), "the link is damaged") << static_cast<int>(byte);
}

TEST(Link, IsRefusedWhereItLeansOnAFileOfAnotherMachine) {
    EXPECT_EQ(refusal("#preset=file&contact.preload=3"), "the link leans on a file of the machine it came from");
}

}  // namespace
}  // namespace stridor::explorer
