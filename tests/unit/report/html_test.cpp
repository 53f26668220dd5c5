#include "stridor/report/html.hpp"

#include <gtest/gtest.h>

namespace stridor::report {
namespace {

Report hostile() {
    const std::string evil = "</pre><script>alert(1)</script>\"'&";
    Report report{
        evil, {{evil, evil}}, evil, {{evil, evil, "#000000", "#FFFFFF", evil}}, {evil}, "<svg></svg>", evil, {}, evil};
    report.sections.push_back(
        {evil, {evil}, "<?xml?><svg></svg>", evil, {{evil}, {{evil}}}, {{evil, evil, evil}}, evil, {evil, evil}});
    return report;
}

TEST(Html, LetsNoTextBecomeMarkup) {
    const std::string page = html(hostile());
    EXPECT_EQ(page.find("<script"), std::string::npos);
    EXPECT_EQ(page.find("</pre><"), page.find("</pre><p class=\"save\">"));
}

TEST(Html, HandsOverTheFirstSheetAlone) {
    Report report{"seal", {{"Part", "51.3372-2"}}, "Squeals", {}, {}, {}, {}, {{"Where it is quiet"}}, "a model"};
    report.sections.push_back({"Details"});
    const std::string page = html(report);
    const std::size_t end = page.find("</footer>\n</div>");
    ASSERT_NE(end, std::string::npos);
    for (const char* first : {"<dt>Part</dt><dd>51.3372-2</dd>", "Squeals", "Where it is quiet", "a model"})
        EXPECT_LT(page.find(first), end) << first;
    EXPECT_GT(page.find("Details"), end);
    EXPECT_NE(page.find(".sheet { break-after: page; }"), std::string::npos);
}

TEST(Html, KeepsEachFigureApart) {
    EXPECT_NE(html(hostile()).find("src=\"data:image/svg+xml;base64,PD94bWw/Pjxzdmc+PC9zdmc+\""), std::string::npos)
        << "names inside of a figure are its own";
}

TEST(Html, MayLoadNothingButWhatItHolds) {
    const std::string page = html(hostile());
    EXPECT_NE(page.find("content=\"default-src 'none'; style-src 'unsafe-inline'; img-src data:; media-src data:\""),
              std::string::npos);
    EXPECT_EQ(page.find("http://"), std::string::npos);
    EXPECT_EQ(page.find("https://"), std::string::npos);
}

TEST(Html, HoldsSoundsAndFilesWhole) {
    Report report{"seal"};
    report.sections.push_back(
        {"file", {}, {}, {}, {}, {{"going", "squeal", "RIFFbytes"}}, {}, {"case.toml", "mu = 1\n"}});
    const std::string page = html(report);
    EXPECT_NE(page.find("src=\"data:audio/wav;base64,UklGRmJ5dGVz\""), std::string::npos);
    EXPECT_NE(page.find("download=\"case.toml\" href=\"data:application/toml;base64,bXUgPSAxCg==\""),
              std::string::npos);
    EXPECT_NE(page.find("<pre tabindex=\"0\">mu = 1\n</pre>"), std::string::npos);
}

}  // namespace
}  // namespace stridor::report
