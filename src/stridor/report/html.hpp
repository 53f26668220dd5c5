#pragma once

#include <string>
#include <string_view>
#include <vector>

/// A report as one HTML file that needs no other file: no picture beside it, no address to load from; and no script but
/// those of a page within it.
namespace stridor::report {

/// A table; every row has as many cells as there are columns.
struct HtmlTable {
    std::vector<std::string> columns{};
    std::vector<std::vector<std::string>> rows{};
};

/// A word on a coloured ground, and a line behind it, to be seen first.
struct Badge {
    std::string label;   // "going"
    std::string word;    // "squeal"
    std::string ground;  // "#BB5566"
    std::string ink;     // of the word, readable on that ground
    std::string more{};  // "428.5 Hz; quiet with joint mass 0.1 -> 0.135 kg"
};

/// A particular of the report: "Part" and its number.
struct Particular {
    std::string name;
    std::string value;
};

/// A sound that can be played in its place.
struct Sound {
    std::string label;
    std::string words;  // the sound in words
    std::string wav;    // the bytes of a WAV file
};

/// Text that can be read, copied and saved as a file.
struct TextFile {
    std::string name;     // "case.toml"
    std::string text;     // as it is read
    std::string saved{};  // as it is saved; empty: as it is read
};

/// A heading with its content below, in this order; empty parts are left out.
struct Section {
    std::string heading;
    std::vector<std::string> paragraphs{};
    std::string svg{};      // a picture, as a file
    std::string caption{};  // of the picture, for readers who cannot see it, too
    HtmlTable table{};
    std::vector<Sound> sounds{};
    std::string code{};  // commands, word for word
    TextFile file{};
    bool fills_sheet = false;  // its picture is as tall as a sheet of paper
};

/// A report from top to bottom. All above `sections` is one sheet of paper, to be handed over alone.
struct Report {
    std::string title;
    std::vector<Particular> facts{};
    std::string headline{};
    std::vector<Badge> badges{};
    std::vector<std::string> lead{};  // paragraphs beside the sketch
    std::string sketch{};             // SVG
    std::string sketch_caption{};
    std::vector<Section> first{};
    std::string foot{};  // of the first sheet
    std::string live{};  // a page in one file on the design, as `stridor page` writes it; empty: none
    std::vector<Section> sections{};
};

/// Returns the whole file. With a page within it the file is in windows-1252, as the page is.
///
/// Throws `Error` (io) if the page has no policy on its scripts.
std::string html(const Report& report);

/// Returns an HTML page printed on A4, as the bytes of a PDF file, by a browser or wkhtmltopdf from PATH.
///
/// Throws `Error` (io) if there is none, with the packages to install, or if it fails.
std::string printed_pdf(std::string_view html);

/// Throws `Error` (io) if no program can print: call it before the work begins.
void expect_printer();

}  // namespace stridor::report
