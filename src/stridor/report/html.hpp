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

/// A word on a ground of its own: what is to be seen first.
struct Badge {
    std::string label;   // "going"
    std::string word;    // "squeal"
    std::string ground;  // "#BB5566"
    std::string ink;     // of the word, to be read on that ground
};

/// A sound that can be played where it stands.
struct Sound {
    std::string label;
    std::string words;  // what is heard
    std::string wav;    // the bytes of a WAV file
};

/// Text that can be read, copied and saved as a file.
struct TextFile {
    std::string name;  // "case.toml"
    std::string text;
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
};

/// A report as its reader sees it, from top to bottom.
struct Report {
    std::string title;
    std::vector<Badge> badges{};
    std::vector<std::string> lead{};  // paragraphs beside the sketch
    std::string sketch{};             // SVG
    std::string sketch_caption{};
    std::vector<Section> sections{};
    std::string foot{};
};

/// The whole file.
std::string html(const Report& report);

}  // namespace stridor::report
