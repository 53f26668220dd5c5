#include "stridor/report/html.hpp"

namespace stridor::report {

namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --ink: #1d2126; --paper: #ffffff; --line: #d5d9de; --soft: #5d6670; }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e7ea; --paper: #15181b; --line: #3a4148; --soft: #9aa4ae; } }
body { font: 15px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; margin: 0; } h2 { font-size: 1.15rem; margin: 2rem 0 .5rem; border-top: 1px solid var(--line); padding-top: 1rem; }
.subtitle, figcaption { color: var(--soft); }
figure { margin: 1rem 0; } figure svg { width: 100%; height: auto; background: #ffffff; border-radius: 4px; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; display: block; overflow-x: auto; }
th, td { text-align: left; padding: .2rem .9rem .2rem 0; border-bottom: 1px solid var(--line); }
pre { overflow-x: auto; padding: .7rem; border: 1px solid var(--line); border-radius: 4px; font-size: 13px; }
@media print { body { margin: 0; max-width: none; } h2 { break-after: avoid; } figure, table { break-inside: avoid; } }
)";

// the picture alone, without what makes it a file of its own
std::string_view inner(std::string_view svg) {
    const std::size_t begin = svg.find("<svg");
    return begin == std::string_view::npos ? std::string_view() : svg.substr(begin);
}

std::string figure(const Section& section) {
    return "<figure role=\"img\" aria-label=\"" + escaped(section.caption) + "\">\n" + std::string(inner(section.svg)) +
           "\n<figcaption>" + escaped(section.caption) + "</figcaption></figure>\n";
}

std::string row(const std::vector<std::string>& cells, std::string_view tag) {
    std::string text = "<tr>";
    for (const std::string& cell : cells)
        text += "<" + std::string(tag) + ">" + escaped(cell) + "</" + std::string(tag) + ">";
    return text + "</tr>\n";
}

std::string table(const Table& table) {
    std::string text = "<table><thead>" + row(table.columns, "th") + "</thead><tbody>\n";
    for (const std::vector<std::string>& cells : table.rows)
        text += row(cells, "td");
    return text + "</tbody></table>\n";
}

std::string html(const Section& section) {
    std::string text = "<section>\n<h2>" + escaped(section.heading) + "</h2>\n";
    for (const std::string& paragraph : section.paragraphs)
        text += "<p>" + escaped(paragraph) + "</p>\n";
    if (!section.svg.empty()) text += figure(section);
    if (!section.table.rows.empty()) text += table(section.table);
    if (!section.code.empty()) text += "<pre>" + escaped(section.code) + "</pre>\n";
    return text + "</section>\n";
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text)
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    return result;
}

std::string html(const Report& report) {
    // the policy keeps the file from ever loading anything, whatever a title holds
    std::string text =
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; img-src "
        "data:\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
        escaped(report.title) + "</title>\n<style>" + std::string(style) + "</style></head><body>\n<h1>" +
        escaped(report.title) + "</h1>\n";
    if (!report.subtitle.empty()) text += "<p class=\"subtitle\">" + escaped(report.subtitle) + "</p>\n";
    for (const Section& section : report.sections)
        text += html(section);
    return text + "</body></html>\n";
}

}  // namespace stridor::report
