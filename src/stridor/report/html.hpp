#pragma once

#include <string>
#include <string_view>
#include <vector>

/// A report as one HTML file that needs nothing else: no script, no picture beside it, no address to load from.
namespace stridor::report {

/// A table; every row has as many cells as there are columns.
struct HtmlTable {
    std::vector<std::string> columns{};
    std::vector<std::vector<std::string>> rows{};
};

/// A word on a ground of its own, and a line behind it: what is to be seen first.
struct Badge {
    std::string label;   // "going"
    std::string word;    // "squeal"
    std::string ground;  // "#BB5566"
    std::string ink;     // of the word, to be read on that ground
    std::string more{};  // "428.5 Hz; quiet with joint mass 0.1 -> 0.135 kg"
};

/// What a report is about: "Part" and its number.
struct Particular {
    std::string name;
    std::string value;
};

/// A sound that can be played where it stands.
struct Sound {
    std::string label;
    std::string words;  // what is heard
    std::string wav;    // the bytes of a WAV file
};

/// Text that can be read, copied and saved as a file.
struct TextFile {
    std::string name;     // "case.toml"
    std::string text;     // as it is read
    std::string saved{};  // as it is saved; empty: as it is read
};

/// A heading with what stands below it, in this order; what is empty is left out.
struct Section {
    std::string heading;
    std::vector<std::string> paragraphs{};
    std::string svg{};      // a picture, as a file
    std::string caption{};  // of the picture, and what it shows to who cannot see it
    HtmlTable table{};
    std::vector<Sound> sounds{};
    std::string code{};  // commands, as they stand
    TextFile file{};
    bool fills_sheet = false;  // its picture is as tall as a sheet of paper
};

/// A report as its reader sees it, from top to bottom. All above `sections` is one sheet of paper, to be handed over
/// alone.
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
    std::vector<Section> sections{};
};

/// The whole file.
std::string html(const Report& report);

/// An HTML page printed on A4, as the bytes of a PDF file, by a browser or wkhtmltopdf that is found on PATH.
///
/// Throws `Error` (io) where there is none, saying what to install, or where it fails.
std::string printed_pdf(std::string_view html);

/// Throws `Error` (io) where no program is there to print: before the work begins.
void expect_printer();

}  // namespace stridor::report
