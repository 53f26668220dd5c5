#pragma once

#include <string>
#include <string_view>
#include <vector>

/// A report as one HTML file that needs nothing else: no script, no picture beside it, no address to load from.
namespace stridor::report {

/// A table; every row has as many cells as there are columns.
struct Table {
    std::vector<std::string> columns{};
    std::vector<std::vector<std::string>> rows{};
};

/// A heading with what stands below it, in this order; what is empty is left out.
struct Section {
    std::string heading;
    std::vector<std::string> paragraphs{};
    std::string svg{};      // a figure, as gnuplot draws it
    std::string caption{};  // of the figure, and what it shows to who cannot see it
    Table table{};
    std::string code{};  // commands or a file, as they stand
};

struct Report {
    std::string title;
    std::string subtitle{};
    std::vector<Section> sections{};
};

/// Text with the characters that mean something to HTML written so that they do not.
std::string escaped(std::string_view text);

/// The whole file.
std::string html(const Report& report);

}  // namespace stridor::report
