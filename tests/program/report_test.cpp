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

std::string base64_text(const std::string& code) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    unsigned bits = 0;
    int count = 0;
    for (const char letter : code.substr(0, code.find('='))) {
        bits = (bits << 6U | static_cast<unsigned>(letters.find(letter))) & 0xFFFFFFU;
        count += 6;
        if (count >= 8) text += static_cast<char>((bits >> static_cast<unsigned>(count -= 8)) & 0xFFU);
    }
    return text;
}

TEST_F(Report, HoldsVerdictSoundChartAdviceAndTheCase) {
    const std::string text = page({"--points", "6"});
    for (const char* part :
         {"Squeals while going, is quiet while coming", "Margin to quiet: ", "What it sounds like",
          "src=\"data:audio/wav;base64,UklGR", "Where it is quiet", "The diamond is the design.", "What to change",
          "<td class=\"short\">advised</td>", "How far it is from another verdict", "download=\"case.toml\"",
          "re 1 nm/s", "stridor report squeal.toml --points 6 -o report.html"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    EXPECT_EQ(text.find("<script"), std::string::npos);
    EXPECT_EQ(text.find("src=\"http"), std::string::npos);
}

TEST_F(Report, TheCaseInItGivesTheSameVerdict) {
    const std::string text = page({"--no-chart", "--no-advice", "--set", "contact.preload=17 N"});
    EXPECT_EQ(text.find("What to change"), std::string::npos);
    EXPECT_EQ(text.find("Where it is quiet"), std::string::npos);
    std::smatch saved;
    ASSERT_TRUE(std::regex_search(text, saved, std::regex("data:application/toml;base64,([^\"]*)")));
    write_text(folder_ / "back.toml", base64_text(saved[1].str()));
    const Finished direct = run({"simulate", "squeal.toml", "--set", "contact.preload=17 N", "--json"}, folder_.path());
    const Finished back = run({"simulate", "back.toml", "--json"}, folder_.path());
    ASSERT_EQ(back.exit_code, 0) << back.err;
    EXPECT_EQ(back.out, direct.out);
}

TEST_F(Report, TheSameCommandGivesTheSamePage) {
    const std::string first = page({"--no-advice", "--points", "5"});
    EXPECT_EQ(page({"--no-advice", "--points", "5"}), first);
}

TEST_F(Report, SaysWhoseItIsAndOfWhichDay) {
    write_text(folder_ / "squeal.toml",
               read_text(folder_ / "squeal.toml") + "\n[document]\nauthor = \"A. <Weber>\"\npart = \"51.3372-2\"\n");
    Process process(Launch{{"report", "squeal.toml", "--no-advice", "--no-chart", "--part", "51.3372-3", "-o", "-"},
                           folder_.path(),
                           {},
                           std::nullopt,
                           {{"SOURCE_DATE_EPOCH", "1763683200"}}});
    const Finished done = process.wait();
    ASSERT_EQ(done.exit_code, 0) << done.err;
    for (const char* fact : {"<dt>Author</dt><dd>A. &lt;Weber&gt;</dd>", "<dt>Part</dt><dd>51.3372-3</dd>",
                             "<dt>Date</dt><dd>2025-11-21</dd>", "<dt>Case</dt><dd>squeal.toml</dd>", "Stridor 0."})
        EXPECT_NE(done.out.find(fact), std::string::npos) << fact;
    EXPECT_EQ(done.err, "") << "a log needs no lines of progress";
    write_text(folder_ / "squeal.toml", read_text(folder_ / "squeal.toml") + "drawing = 3\n");
    EXPECT_NE(report({"--no-advice", "--no-chart"}).err.find("unknown key document.drawing"), std::string::npos);
}

TEST_F(Report, PrintsTheCaseOnce) {
    const std::string text = page({"--no-advice", "--no-chart"});
    const std::string line = "preload = &quot;20 N&quot;";
    ASSERT_NE(text.find(line), std::string::npos);
    EXPECT_EQ(text.find(line), text.rfind(line));
    EXPECT_NE(text.find("# force that presses joint and plate together at rest (F)"), std::string::npos);
}

TEST_F(Report, TakesTheAxesOfACharts) {
    write_text(folder_ / "wiper.toml", run({"init", "wiper"}).out);
    const Finished done = run({"report", "wiper.toml", "--no-advice", "--points", "4", "-o", "-"}, folder_.path());
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(done.out.find("4 by 4 cells"), std::string::npos);
    EXPECT_NE(page({"--no-advice", "--x", "incidence_angle=50:80:3", "--y", "mu_d=0.2:0.6:3"})
                  .find("3 by 3 cells in each direction"),
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

// of the tree of pages, which stands last
std::size_t page_count(const std::string& pdf) {
    const std::size_t at = pdf.rfind("/Count ");
    return at == std::string::npos ? 0 : std::stoul(pdf.substr(at + 7));
}

TEST_F(Report, IsPrintedWhereABrowserIsThere) {
    STRIDOR_NEEDS(std::system("command -v chromium > /dev/null 2>&1") == 0, "Chromium", "chromium");
    const Finished done = report({"--no-advice", "--points", "4", "-o", "report.pdf"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    const std::string bytes = read_text(folder_.path() / "report.pdf");
    EXPECT_TRUE(bytes.starts_with("%PDF-"));
    EXPECT_GT(bytes.size(), 20000U);
    EXPECT_LE(page_count(bytes), 4U) << "page one, pictures, figures, the case";
}

// a program with a page beside it, which is short
class LiveReport : public Report {
protected:
    void SetUp() override {
        Report::SetUp();
        std::filesystem::create_directories(folder_ / "bin/page");
        std::error_code other_disk;
        std::filesystem::create_hard_link(stridor::support::program(), folder_ / "bin/stridor", other_disk);
        if (other_disk) std::filesystem::copy_file(stridor::support::program(), folder_ / "bin/stridor");
    }

    Finished live(std::vector<std::string> more) const {
        Launch launch;
        launch.arguments = {"report", "squeal.toml", "--live", "--no-chart", "--no-advice"};
        launch.folder = folder_.path();
        launch.arguments.insert(launch.arguments.end(), more.begin(), more.end());
        launch.program = folder_ / "bin/stridor";
        return run(launch);
    }
};

TEST_F(LiveReport, HoldsThePageWithItsCase) {
    write_text(folder_ / "bin/page/page.html",
               "<meta content=\"script-src 'sha256-x=' 'wasm-unsafe-eval'; style-src y\">"
               "<script type=\"application/json\" id=\"stridor-case\">null</script>\xE9");
    const Finished done = live({"--set", "contact.preload=17", "-o", "report.html"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    const std::string text = read_text(folder_ / "report.html");
    for (const char* part :
         {"preload = \\&quot;17 N\\&quot;", "</script>\xE9\"></iframe>", "<meta charset=\"windows-1252\">",
          "script-src 'sha256-x=' 'wasm-unsafe-eval'; worker-src blob:;", "--no-advice --live -o"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST_F(LiveReport, IsRefusedOnPaperAndWithoutAPageBeforeTheWorkBegins) {
    const Finished paper = live({"-o", "report.pdf"});
    EXPECT_EQ(paper.exit_code, 2);
    EXPECT_NE(paper.err.find("a PDF cannot be live"), std::string::npos) << paper.err;
    const Finished without = live({"-o", "report.html"});
    EXPECT_EQ(without.exit_code, 5);
    EXPECT_NE(without.err.find("this stridor has no page in one file"), std::string::npos) << without.err;
    EXPECT_NE(without.err.find("./dev page"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "report.html"));
}

}  // namespace
