#include "stridor/pictures/picture_files.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/drawing/picture.hpp"
#include "stridor/pictures/diagram.hpp"
#include "stridor/pictures/many_contacts.hpp"
#include "stridor/pictures/noise_chart.hpp"
#include "stridor/pictures/parts/design_mark.hpp"
#include "stridor/pictures/stability.hpp"
#include "stridor/pictures/time_history.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <array>
#include <optional>

namespace stridor::pictures {

namespace {

// long enough for a few dozen changes of state of a squeal
constexpr double zoom_length = 20e-3;  // [s]

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

}  // namespace

void draw(const drawing::Scene& scene, const std::filesystem::path& path) {
    storage::write_file(path.string(), drawing::render(scene, drawing::format_of(path)));
}

void draw_both(const drawing::Scene& scene, const std::filesystem::path& stem) {
    draw_each(scene, stem, std::array<std::string, 2>{".png", ".svg"});
}

void draw_each(const drawing::Scene& scene, const std::filesystem::path& stem, std::span<const std::string> endings) {
    for (const std::string& ending : endings)
        draw(scene, std::filesystem::path(stem) += ending);
}

drawing::Scene motion_scene(const parameters::Case& c, const record::Record& record, const std::string& zoom) {
    const std::optional<drawing::Extent> stretch = zoom_range(c, record, zoom);
    if (shows_many_contacts(c)) return many_contacts(c, record, stretch);
    TimeHistoryOptions options;
    options.zoom = stretch;
    return time_history(c, record, options);
}

void draw_stability(const analysis::StabilityScan& scan, const std::string& path) {
    std::vector<StabilityCurve> curves;
    for (const analysis::DirectionScan& direction : scan.directions)
        curves.push_back({direction.direction, direction.path});
    draw(stability(scan.key, curves), path);
}

void draw_diagram(const sweep::SweepResult& result, const std::vector<sweep::DiagramCell>& cells,
                  const std::filesystem::path& folder, std::span<const std::string> endings) {
    drawing::Scene scene = diagram(result, cells);
    mark_design(scene, result.study);
    draw_each(scene, folder / "chart", endings);
}

void draw_charts(const sweep::SweepResult& result, const std::filesystem::path& folder,
                 std::span<const std::string> endings) {
    if (endings.empty()) return;
    // the first quantity is the chart; further ones stand beside it under their own names
    bool is_first = true;
    for (const std::string& quantity : result.study.quantities) {
        drawing::Scene scene = quantity_chart(result, quantity);
        mark_design(scene, result.study);
        draw_each(scene, folder / (is_first ? "chart" : "chart-" + quantity), endings);
        is_first = false;
    }
}

}  // namespace stridor::pictures
