#include "stridor/report/html.hpp"

#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

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

// the text of an attribute as a browser reads it
std::string attribute(const std::string& page, const std::string& name) {
    const std::string begin = name + "=\"";
    const std::size_t at = page.find(begin) + begin.size();
    std::string text = page.substr(at, page.find('"', at) - at);
    for (const auto& [written, letter] : {std::pair{"&quot;", "\""}, std::pair{"&amp;", "&"}})
        for (std::size_t k = 0; (k = text.find(written, k)) != text.npos; ++k)
            text.replace(k, std::string(written).size(), letter);
    return text;
}

TEST(Html, HoldsALivePageByteForByteAndRunsItsScriptsAlone) {
    Report report = hostile();
    report.headline =
        "Gr\xC3\xB6\xC3\x9F"
        "e \xE2\x89\xA4 \xF0\x9F\x94\x94";
    std::string bytes =
        "<meta content=\"default-src 'none'; script-src 'sha256-abc=' 'wasm-unsafe-eval'; style-src x\">";
    for (int byte = 1; byte < 256; ++byte)
        bytes += static_cast<char>(byte);
    report.live = bytes + "&amp;&quot;</iframe><script>";
    const std::string page = html(report);
    EXPECT_EQ(attribute(page, "srcdoc"), report.live);
    EXPECT_NE(page.find("<meta charset=\"windows-1252\">"), page.npos);
    EXPECT_NE(page.find("; script-src 'sha256-abc=' 'wasm-unsafe-eval'; worker-src blob:; img-src data: blob:;"),
              page.npos);
    EXPECT_NE(page.find("Gr&#246;&#223;e &#8804; &#128276;"), page.npos);
    // beside the frame's text there is no script, and no letter that depends on the encoding
    const std::size_t begin = page.find("srcdoc=\"");
    const std::string around = page.substr(0, begin) + page.substr(page.find("\"></iframe>", begin));
    EXPECT_EQ(around.find("<script"), around.npos);
    EXPECT_TRUE(std::all_of(around.begin(), around.end(), [](char letter) { return letter >= 0; }));
    EXPECT_NE(page.find("@media (scripting: none) { .live { display: none; } }"), page.npos);
}

TEST(Html, RefusesALivePageWithoutAPolicy) {
    Report report{"seal"};
    report.live = "<p>";
    EXPECT_TRUE(support::thrown_by([&] { html(report); }).says("no policy on its scripts"));
}

}  // namespace
}  // namespace stridor::report
