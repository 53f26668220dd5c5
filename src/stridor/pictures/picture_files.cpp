#include "stridor/pictures/picture_files.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/drawing/labels.hpp"
#include "stridor/drawing/picture.hpp"
#include "stridor/pictures/diagram.hpp"
#include "stridor/pictures/many_contacts.hpp"
#include "stridor/pictures/noise_chart.hpp"
#include "stridor/pictures/parts/chart_cells.hpp"
#include "stridor/pictures/time_history.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

namespace stridor::pictures {

namespace {

// long enough for a few dozen changes of state of a squeal
constexpr double zoom_length = 20e-3;  // [s]

constexpr double widest_sheet = 300.0;  // [mm]

std::optional<drawing::Extent> zoom_range(const parameters::Case& c, const record::Record& record,
                                          const std::string& zoom) {
    if (zoom.empty()) {
        const double length = shows_many_contacts(c) ? telling_length(c, record) : zoom_length;
        return busiest_stretch(c, record.histories, length);
    }
    const std::size_t colon = zoom.find(':');
    if (colon == std::string::npos)
        throw Error(ErrorKind::input,
                    {"--zoom \"" + zoom + "\" cannot be read", "expected FROM:TO", "For example \"230 ms:250 ms\"."});
    const drawing::Extent range{base::parse_quantity(zoom.substr(0, colon), "s"),
                                base::parse_quantity(zoom.substr(colon + 1), "s")};
    if (!(range.from < range.to))
        throw Error(ErrorKind::input,
                    {"--zoom \"" + zoom + "\" is empty", "its end must come after its beginning", ""});
    return range;
}

// Half as wide is three quarters as high, and higher where texts would touch. Nothing where that does not help.
std::optional<drawing::Scene> with_width(drawing::Scene scene, double width) {
    constexpr double growth = 1.3, most = 1.5;  // [1] of the height
    const double highest = most * scene.height;
    scene.height *= 0.5 + 0.5 * width / scene.width;
    scene.width = width;
    for (; scene.height < highest; scene.height *= growth)
        if (drawing::is_legible(drawing::arrange(scene), width)) return scene;
    return std::nullopt;
}

}  // namespace

drawing::Scene on_sheet(drawing::Scene scene, const Sheet& sheet) {
    if (sheet.title && sheet.title->empty()) scene.title_text = drawing::TitleText::left_out;
    if (sheet.title && !sheet.title->empty()) scene.title = *sheet.title;
    if (!sheet.width) return scene;
    if (const auto narrow = with_width(scene, *sheet.width)) return *narrow;
    constexpr double step = 10.0;  // [mm]
    double least = step * std::ceil(*sheet.width / step);
    while (least < widest_sheet && !with_width(scene, least))
        least += step;
    throw Error(ErrorKind::input,
                {fmt::format("the picture has no room on {:g} mm", *sheet.width),
                 "letters stay readable, and some of them would touch or leave the sheet",
                 least < widest_sheet ? fmt::format("Give it {:g} mm.", least) : "Shorten the names that it shows."});
}

void draw(const drawing::Scene& scene, const std::filesystem::path& path, const Sheet& sheet) {
    storage::write_file(path.string(), drawing::render(on_sheet(scene, sheet), drawing::format_of(path)));
}

void draw_both(const drawing::Scene& scene, const std::filesystem::path& stem, const Sheet& sheet) {
    draw_each(scene, stem, std::array<std::string, 2>{".png", ".svg"}, sheet);
}

void draw_each(const drawing::Scene& scene, const std::filesystem::path& stem, std::span<const std::string> endings,
               const Sheet& sheet) {
    for (const std::string& ending : endings)
        draw(scene, std::filesystem::path(stem) += ending, sheet);
}

drawing::Scene motion_scene(const parameters::Case& c, const record::Record& record, const std::string& zoom) {
    const std::optional<drawing::Extent> stretch = zoom_range(c, record, zoom);
    if (shows_many_contacts(c)) return many_contacts(c, record, stretch);
    TimeHistoryOptions options;
    options.zoom = stretch;
    return time_history(c, record, options);
}

void draw_diagram(const sweep::SweepResult& result, const std::vector<sweep::DiagramCell>& cells,
                  const std::filesystem::path& folder, std::span<const std::string> endings, const Sheet& sheet) {
    drawing::Scene scene = diagram(result, cells);
    mark_design(scene, result.study);
    draw_each(scene, folder / "chart", endings, sheet);
}

void draw_charts(const sweep::SweepResult& result, const std::filesystem::path& folder,
                 std::span<const std::string> endings, const Sheet& sheet) {
    if (endings.empty()) return;
    // the first quantity is the chart; further ones stand beside it under their own names
    bool is_first = true;
    for (const std::string& quantity : result.study.quantities) {
        drawing::Scene scene = quantity_chart(result, quantity);
        mark_design(scene, result.study);
        draw_each(scene, folder / (is_first ? "chart" : "chart-" + quantity), endings, sheet);
        is_first = false;
    }
}

}  // namespace stridor::pictures
