#include "stridor/report/html.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/base/process.hpp"
#include "stridor/base/text.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/storage/new_file.hpp"

#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>

namespace stridor::report {

namespace {

using base::markup_text;

constexpr std::string_view style = R"css(
:root { color-scheme: light dark; --ink: #1d2126; --paper: #ffffff; --line: #d5d9de; --soft: #5d6670;
  --field: #f5f6f7; --link: #006699; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e7ea; --paper: #15181b; --line: #3a4148; --soft: #9aa4ae; --field: #1e2327; --link: #6bb8e0; }
}
* { box-sizing: border-box; }
body { font: 16px/1.5 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; color: var(--ink);
  background: var(--paper); max-width: 62rem; margin: 2.5rem auto; padding: 0 1.25rem; overflow-wrap: break-word; }
h1 { font-size: 1.7rem; line-height: 1.25; margin: 0; }
.top { display: flex; flex-wrap: wrap; justify-content: space-between; gap: .8rem 2.5rem; align-items: flex-start;
  border-bottom: 2px solid var(--ink); padding-bottom: .8rem; margin-bottom: 1rem; }
.top h1 { flex: 1 1 18rem; }
.facts { display: grid; grid-template-columns: auto auto; gap: .1rem .9rem; margin: 0; font-size: .9rem; }
.facts dt { color: var(--soft); }
.facts { max-width: 22rem; }
.facts dd { margin: 0; overflow-wrap: anywhere; min-width: 0; }
h1.long { font-size: 1.15rem; }
.headline { font-size: 1.25rem; font-weight: 650; max-width: none; margin: 0 0 .8rem; }
h2 { font-size: 1.2rem; margin: 2.2rem 0 .6rem; border-top: 1px solid var(--line); padding-top: 1.1rem; }
p { margin: .5rem 0; max-width: 46rem; }
a { color: var(--link); }
.overview { display: grid; grid-template-columns: minmax(0, 3fr) minmax(15rem, 2fr); gap: 2rem; align-items: start; }
.badges { margin: 0 0 1rem; padding: 0; list-style: none; }
.badges li { display: flex; flex-wrap: wrap; gap: .3rem .9rem; align-items: baseline; margin: 0 0 .4rem; }
.badge { border-radius: 6px; padding: .2rem .7rem; border: 1px solid var(--line); min-width: 11rem;
  print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.badge + span { flex: 1 1 18rem; }
.sketch { margin: 0; }
.sketch svg { width: 100%; max-width: 24rem; height: auto; display: block; }
figcaption, footer { color: var(--soft); font-size: .9rem; }
figure { margin: 1rem 0; }
.frame { overflow-x: auto; background: #ffffff; border-radius: 6px; border: 1px solid var(--line); }
.frame img { width: 100%; min-width: 38rem; height: auto; display: block;
  print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.scroll { overflow-x: auto; margin: .8rem 0; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .92rem; overflow-wrap: normal; }
th, td { text-align: left; padding: .25rem 1.1rem .25rem 0; border-bottom: 1px solid var(--line);
  vertical-align: top; }
.short { white-space: nowrap; }
th { color: var(--soft); font-weight: 600; }
pre { overflow-x: auto; margin: .8rem 0; padding: .8rem 1rem; background: var(--field); border: 1px solid var(--line);
  border-radius: 6px; font: 13px/1.45 ui-monospace, "DejaVu Sans Mono", monospace; }
.file pre { max-height: 26rem; overflow-y: auto; }
.sound { margin: .8rem 0; }
.sound audio { display: block; width: 100%; max-width: 30rem; margin: .3rem 0; }
.live iframe { display: block; width: 100%; height: 56rem; max-height: 92vh; border: 1px solid var(--line);
  border-radius: 6px; }
.live summary { cursor: pointer; font-size: 1.2rem; font-weight: 650; margin: 1.5rem 0 .6rem; }
footer { border-top: 1px solid var(--line); margin-top: 2.5rem; padding: .8rem 0 1.5rem; }
@media (scripting: none) { .live { display: none; } }
@media (max-width: 44rem) {
  body { margin-top: 1.25rem; padding: 0 .9rem; }
  .overview { grid-template-columns: minmax(0, 1fr); gap: 1rem; }
  h1 { font-size: 1.4rem; }
}
@page { size: A4; margin: 12mm 14mm 14mm;
  @bottom-right { content: counter(page) " / " counter(pages); font: 8pt sans-serif; } }
@media print {
  :root { color-scheme: light; --ink: #000000; --paper: #ffffff; --line: #c4c8cc; --soft: #444444; --field: #ffffff;
    --link: #000000; }
  body { margin: 0; padding: 0; max-width: none; font-size: 9pt; line-height: 1.4; }
  p { max-width: none; margin: .35rem 0; }
  h1 { font-size: 15pt; }
  h2 { font-size: 11pt; margin: .8rem 0 .3rem; padding-top: .5rem; break-after: avoid; }
  .headline { font-size: 13pt; }
  .top { margin-bottom: .7rem; padding-bottom: .5rem; flex-wrap: nowrap; }
  .top h1 { flex-basis: 9cm; }
  h1.long { font-size: 11pt; }
  .facts { font-size: 8.5pt; flex: 0 1 auto; max-width: 7cm; }
  .overview { grid-template-columns: minmax(0, 3fr) 4.8cm; }
  .sketch figcaption { display: none; }
  figure { margin: .4rem 0; }
  figcaption, footer { font-size: 8pt; }
  footer { margin-top: .7rem; padding: .4rem 0 0; }
  figure, .sound, .badges, tr { break-inside: avoid; }
  .frame { overflow: visible; border: 0; }
  .frame img { min-width: 0; width: auto; max-width: 100%; max-height: 92mm; margin: auto; }
  .sheet .frame img { max-height: 76mm; }
  .whole img { max-height: 222mm; }
  .scroll { overflow: visible; margin: .4rem 0; }
  table { font-size: 8pt; }
  th, td { padding-top: .12rem; padding-bottom: .12rem; }
  pre, .file pre { max-height: none; overflow: visible; white-space: pre-wrap; font-size: 7pt; line-height: 1.28;
    padding: .4rem .6rem; }
  .sheet { break-after: page; }
  audio, .save, .live { display: none !important; }
  .heard::after { content: " (To be played in the HTML file.)"; }
}
)css";

std::string data_address(std::string_view media_type, std::string_view bytes) {
    return "data:" + std::string(media_type) + ";base64," + base::base64(bytes);
}

// as an image: the names inside of it stay apart from those of the other pictures
std::string figure(const Section& section) {
    return "<figure><div class=\"frame" + std::string(section.fills_sheet ? " whole" : "") +
           "\" tabindex=\"0\"><img alt=\"" + markup_text(section.caption) + "\" src=\"" +
           data_address("image/svg+xml", section.svg) + "\"></div><figcaption>" + markup_text(section.caption) +
           "</figcaption></figure>\n";
}

std::string sound(const Sound& sound) {
    return "<div class=\"sound\"><b>" + markup_text(sound.label) + "</b> <span class=\"heard\">" +
           markup_text(sound.words) + "</span><audio controls preload=\"metadata\" aria-label=\"" +
           markup_text(sound.label) + "\" src=\"" + data_address("audio/wav", sound.wav) + "\"></audio></div>\n";
}

std::string file(const TextFile& file) {
    return "<div class=\"file\"><pre tabindex=\"0\">" + markup_text(file.text) +
           "</pre><p class=\"save\"><a download=\"" + markup_text(file.name) + "\" href=\"" +
           data_address("application/toml", file.saved.empty() ? file.text : file.saved) + "\">Save as " +
           markup_text(file.name) + "</a></p></div>\n";
}

std::string row(const std::vector<std::string>& cells, std::string_view tag) {
    std::string text = "<tr>";
    constexpr std::size_t longest_word = 24;  // [1] characters; what is shorter stays on one line
    for (const std::string& cell : cells)
        text += "<" + std::string(tag) + (cell.size() <= longest_word ? " class=\"short\">" : ">") + markup_text(cell) +
                "</" + std::string(tag) + ">";
    return text + "</tr>\n";
}

std::string table(const HtmlTable& table) {
    std::string text = "<div class=\"scroll\"><table><thead>" + row(table.columns, "th") + "</thead><tbody>\n";
    for (const std::vector<std::string>& cells : table.rows)
        text += row(cells, "td");
    return text + "</tbody></table></div>\n";
}

std::string html(const Section& section) {
    std::string text = "<section>\n<h2>" + markup_text(section.heading) + "</h2>\n";
    for (const std::string& paragraph : section.paragraphs)
        text += "<p>" + markup_text(paragraph) + "</p>\n";
    if (!section.svg.empty()) text += figure(section);
    if (!section.table.rows.empty()) text += table(section.table);
    for (const Sound& each : section.sounds)
        text += sound(each);
    if (!section.code.empty()) text += "<pre>" + markup_text(section.code) + "</pre>\n";
    if (!section.file.text.empty()) text += file(section.file);
    return text + "</section>\n";
}

std::string top(const Report& report) {
    constexpr std::size_t long_title = 70;  // [byte] what is longer has smaller type, so that page one stays one sheet
    std::string text = "<header class=\"top\"><h1" +
                       std::string(report.title.size() > long_title ? " class=\"long\"" : "") + ">" +
                       markup_text(report.title) + "</h1>\n<dl class=\"facts\">";
    for (const Particular& fact : report.facts)
        text += "<dt>" + markup_text(fact.name) + "</dt><dd>" + markup_text(fact.value) + "</dd>";
    return text + "</dl></header>\n<p class=\"headline\">" + markup_text(report.headline) + "</p>\n";
}

std::string badges(const Report& report) {
    std::string text = "<ul class=\"badges\">";
    for (const Badge& badge : report.badges)
        text += "<li><span class=\"badge\" style=\"background:" + badge.ground + ";color:" + badge.ink + "\">" +
                markup_text(badge.label) + " <b>" + markup_text(badge.word) + "</b></span><span>" +
                markup_text(badge.more) + "</span></li>";
    return text + "</ul>\n";
}

std::string overview(const Report& report) {
    std::string text = "<div class=\"overview\"><div>\n";
    for (const std::string& paragraph : report.lead)
        text += "<p>" + markup_text(paragraph) + "</p>\n";
    text += "</div>\n";
    if (!report.sketch.empty())
        text += "<figure class=\"sketch\" role=\"img\" aria-label=\"" + markup_text(report.sketch_caption) + "\">" +
                report.sketch + "<figcaption>" + markup_text(report.sketch_caption) + "</figcaption></figure>\n";
    return text + "</div>\n";
}

// Read when it is opened; without scripts it is not shown. Its letters are the page's bytes.
std::string live(std::string_view page) {
    std::string text =
        "<details class=\"live\"><summary>Try it: change the design</summary>\n<p>The program is inside: move a slider "
        "and "
        "see the verdict and the chart. Nothing leaves this machine.</p>\n<iframe loading=\"lazy\" title=\"The design, "
        "live\" allow=\"autoplay; clipboard-write\" srcdoc=\"";
    for (const char letter : page) {
        if (letter == '&')
            text += "&amp;";
        else if (letter == '"')
            text += "&quot;";
        else
            text += letter;
    }
    return text + "\"></iframe></details>\n";
}

// what the page's own policy allows it to run; the frame is under the report's policy as well
std::string scripts_of(std::string_view page) {
    constexpr std::string_view begin = "script-src ";
    const std::size_t at = page.find(begin);
    const std::size_t end = page.find(';', at);
    if (at == page.npos || end == page.npos)
        throw Error(ErrorKind::io, {"the page in one file is damaged", "it has no policy on its scripts", ""});
    return std::string(page.substr(at, end - at)) + "; worker-src blob:; ";
}

// letters beyond ASCII as HTML writes them, whatever the file's encoding
std::string in_ascii(std::string_view text) {
    std::string ascii;
    for (std::size_t k = 0; k < text.size();) {
        const auto first = static_cast<unsigned char>(text[k++]);
        if (first < 0x80) {
            ascii += static_cast<char>(first);
            continue;
        }
        unsigned code = first >= 0xf0 ? first & 0x07u : first >= 0xe0 ? first & 0x0fu : first & 0x1fu;
        for (; k < text.size() && (static_cast<unsigned char>(text[k]) & 0xc0u) == 0x80u; ++k)
            code = code << 6 | (static_cast<unsigned char>(text[k]) & 0x3fu);
        ascii += "&#" + std::to_string(code) + ";";
    }
    return ascii;
}

constexpr std::array<std::string_view, 6> browsers{
    "chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "microsoft-edge", "brave-browser"};
constexpr std::string_view converter = "wkhtmltopdf";

// it takes some seconds
constexpr std::chrono::seconds longest_printing{300};

// the first that is there; empty if none is
std::string found_printer() {
    for (const std::string_view browser : browsers)
        if (base::is_on_path(std::string(browser))) return std::string(browser);
    return base::is_on_path(std::string(converter)) ? std::string(converter) : std::string();
}

std::vector<std::string> command_for(const std::string& printer, const std::filesystem::path& folder) {
    const std::string page = (folder / "report.html").string();
    const std::string sheet = (folder / "report.pdf").string();
    if (printer == converter) return {printer, "--quiet", "--page-size", "A4", "--print-media-type", page, sheet};
    std::vector<std::string> command{printer,
                                     "--headless",
                                     "--disable-gpu",
                                     "--no-first-run",
                                     "--no-pdf-header-footer",
                                     "--user-data-dir=" + (folder / "profile").string(),
                                     "--print-to-pdf=" + sheet};
    // a browser has no sandbox for root; the page is ours and runs no script
    if (::geteuid() == 0) command.emplace_back("--no-sandbox");
    command.push_back("file://" + page);
    return command;
}

}  // namespace

std::string html(const Report& report) {
    const bool is_live = !report.live.empty();
    // the policy keeps the file from ever loading anything, whatever a title holds
    std::string text = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"" +
                       std::string(is_live ? "windows-1252" : "utf-8") +
                       "\">\n<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
                       "'unsafe-inline'; " +
                       (is_live ? scripts_of(report.live) + "img-src data: blob:; media-src data: blob:"
                                : std::string("img-src data:; media-src data:")) +
                       "\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
                       markup_text(report.title) + "</title>\n<style>" + std::string(style) +
                       "</style></head><body>\n<div class=\"sheet\">";
    text += top(report) + badges(report) + overview(report);
    for (const Section& section : report.first)
        text += html(section);
    if (!report.foot.empty()) text += "<footer>" + markup_text(report.foot) + "</footer>\n";
    text += "</div>\n";
    std::string rest;
    for (const Section& section : report.sections)
        rest += html(section);
    rest += "</body></html>\n";
    return is_live ? in_ascii(text) + live(report.live) + in_ascii(rest) : text + rest;
}

void expect_printer() {
    if (!found_printer().empty()) return;
    throw Error(ErrorKind::io,
                {"no program is there to make a PDF", "a browser (chromium, google-chrome) or wkhtmltopdf prints it",
                 "Install one, on Debian with: apt install chromium. Or write FILE.html and print that."});
}

std::string printed_pdf(std::string_view html) {
    expect_printer();
    const std::string printer = found_printer();
    const storage::PrivateFolder folder;
    storage::write_file((folder.path() / "report.html").string(), html);
    const base::ProcessResult result = base::run_process(command_for(printer, folder.path()), longest_printing);
    const std::filesystem::path sheet = folder.path() / "report.pdf";
    if (result.exit_status != 0 || !std::filesystem::exists(sheet)) {
        const std::string message(base::trimmed(result.messages));
        throw Error(ErrorKind::io, {printer + " could not print the report", message.substr(message.rfind('\n') + 1),
                                    "Write FILE.html and print that."});
    }
    return storage::read_file(sheet.string());
}

}  // namespace stridor::report
