#include "support/needs.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>

using stridor::support::Finished;
using stridor::support::Launch;
using stridor::support::Process;
using stridor::support::read_text;
using stridor::support::run;
using stridor::support::ScratchFolder;
using stridor::support::write_text;

namespace {

class Report : public testing::Test {
protected:
    void SetUp() override { write_text(folder_ / "squeal.toml", run({"init", "squeal"}).out); }

    Finished report(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"report", "squeal.toml"});
        return run(arguments, folder_.path());
    }

    std::string page(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"-o", "report.html"});
        const Finished done = report(std::move(arguments));
        EXPECT_EQ(done.exit_code, 0) << done.err;
        EXPECT_EQ(done.out, "report.html\n");
        return read_text(folder_.path() / "report.html");
    }

    ScratchFolder folder_;
};

std::string unescaped(std::string text) {
    for (const auto& [from, to] :
         {std::pair("&quot;", "\""), std::pair("&lt;", "<"), std::pair("&gt;", ">"), std::pair("&amp;", "&")})
        text = std::regex_replace(text, std::regex(from), to);
    return text;
}

TEST_F(Report, HoldsVerdictSoundChartAdviceAndTheCase) {
    const std::string text = page({"--points", "6"});
    for (const char* part :
         {"The model predicts noise of this design while going, and none while coming.", "What it sounds like",
          "src=\"data:audio/wav;base64,UklGR", "Where it is quiet", "The diamond is the design.", "What to change",
          "Advised: ", "How far it is from another verdict", "download=\"case.toml\"", "re 1 nm/s",
          "stridor report squeal.toml --points 6 -o report.html"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    EXPECT_EQ(text.find("<script"), std::string::npos);
    EXPECT_EQ(text.find("src=\"http"), std::string::npos);
}

TEST_F(Report, TheCaseInItGivesTheSameVerdict) {
    const std::string text = page({"--no-chart", "--no-advice", "--set", "contact.preload=17 N"});
    EXPECT_EQ(text.find("What to change"), std::string::npos);
    EXPECT_EQ(text.find("Where it is quiet"), std::string::npos);
    const std::size_t from = text.find("title = &quot;");
    const std::size_t to = text.find("</pre>", from);
    ASSERT_NE(from, std::string::npos);
    write_text(folder_ / "back.toml", unescaped(text.substr(from, to - from)));
    const Finished direct = run({"simulate", "squeal.toml", "--set", "contact.preload=17 N", "--json"}, folder_.path());
    const Finished back = run({"simulate", "back.toml", "--json"}, folder_.path());
    ASSERT_EQ(back.exit_code, 0) << back.err;
    EXPECT_EQ(back.out, direct.out);
}

TEST_F(Report, TheSameCommandGivesTheSamePage) {
    const std::string first = page({"--no-advice", "--points", "5"});
    EXPECT_EQ(page({"--no-advice", "--points", "5"}), first);
}

TEST_F(Report, TakesTheAxesOfACharts) {
    write_text(folder_ / "wiper.toml", run({"init", "wiper"}).out);
    const Finished done = run({"report", "wiper.toml", "--no-advice", "--points", "4", "-o", "-"}, folder_.path());
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(done.out.find("4 by 4 cells"), std::string::npos);
    EXPECT_NE(page({"--no-advice", "--x", "incidence_angle=50:80:3", "--y", "mu_d=0.2:0.6:3"})
                  .find("Category over joint.incidence_angle and contact.kinetic_friction, 3 by 3 cells"),
              std::string::npos);
}

TEST_F(Report, RefusesWhatItCannotWrite) {
    EXPECT_EQ(report({"-o", "report.txt"}).exit_code, 2);
    EXPECT_EQ(report({"--x", "preload=1:40", "-o", "report.html"}).exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "report.html"));
}

TEST_F(Report, WithoutAPrinterSaysWhatToInstall) {
    Process process(Launch{
        {"report", "squeal.toml", "-o", "report.pdf"}, folder_.path(), {}, std::nullopt, {{"PATH", "/nowhere"}}});
    const Finished done = process.wait();
    EXPECT_EQ(done.exit_code, 5) << done.err;
    EXPECT_NE(done.err.find("apt install chromium"), std::string::npos) << done.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "report.pdf"));
}

TEST_F(Report, IsPrintedWhereABrowserIsThere) {
    STRIDOR_NEEDS(std::system("command -v chromium > /dev/null 2>&1") == 0, "Chromium", "chromium");
    const Finished done = report({"--no-advice", "--points", "4", "-o", "report.pdf"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    const std::string bytes = read_text(folder_.path() / "report.pdf");
    EXPECT_TRUE(bytes.starts_with("%PDF-"));
    EXPECT_GT(bytes.size(), 20000U);
}

}  // namespace
