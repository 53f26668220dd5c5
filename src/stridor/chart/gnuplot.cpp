#include "stridor/chart/gnuplot.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/chart/process.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace stridor::chart {

namespace {

// the first line of gnuplot's complaint that says something: it shows the command and a caret first
std::string complaint(const std::string& messages) {
    for (std::size_t from = 0; from < messages.size();) {
        const std::size_t end = std::min(messages.find('\n', from), messages.size());
        const std::string_view line = base::trimmed(std::string_view(messages).substr(from, end - from));
        if (line.find(": ") != std::string_view::npos) return std::string(line);
        from = end + 1;
    }
    return std::string(base::trimmed(messages));
}

// SVG readers disagree about blanks at the ends of a styled run ("preload " before an italic F): tell them to keep all
std::string with_blanks_kept(const std::string& svg) {
    constexpr std::string_view plain = "<text>";
    constexpr std::string_view keeping = "<text xml:space=\"preserve\">";
    std::string result;
    std::size_t from = 0;
    for (std::size_t at = svg.find(plain); at != std::string::npos; at = svg.find(plain, from)) {
        result.append(svg, from, at - from).append(keeping);
        from = at + plain.size();
    }
    return result.append(svg, from);
}

}  // namespace

Format format_of(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    if (extension == ".png") return Format::png;
    if (extension == ".svg") return Format::svg;
    throw Error(ErrorKind::input, {"cannot draw into " + path.string(), "a picture is a .png or a .svg file",
                                   "Give the name one of these endings."});
}

bool can_draw() {
    return is_on_path("gnuplot");
}

std::string render(const Scene& scene, Format format) {
    if (!can_draw())
        throw Error(ErrorKind::io, {"gnuplot is not installed", "it draws the figures",
                                    "Install it, on Debian with: apt install gnuplot-nox"});
    // without the user's own start-up files: the same scene gives the same picture
    const ProcessResult result = run_process({"gnuplot", "--default-settings"}, script(scene, format));
    if (result.exit_status != 0 || result.output.empty())
        throw Error(ErrorKind::io, {"gnuplot could not draw the figure", complaint(result.messages),
                                    "Version 5.4 with the pngcairo and svg terminals is needed."});
    return format == Format::svg ? with_blanks_kept(result.output) : result.output;
}

}  // namespace stridor::chart
