#include "stridor/drawing/picture.hpp"

#include "stridor/base/error.hpp"
#include "stridor/drawing/panel_drawer.hpp"

namespace stridor::drawing {

namespace {

Panel colour_bar_panel(const ColourBar& bar) {
    constexpr std::size_t steps = 128;
    Panel panel;
    panel.frame = Frame::closed;
    panel.x.range = {0.0, 1.0};
    panel.y.scale = bar.colours.scale;
    panel.y.range = bar.colours.range;
    ValueCells cells;
    cells.x_edges = {0.0, 1.0};
    cells.colours = bar.colours;
    for (std::size_t i = 0; i <= steps; ++i)
        cells.y_edges.push_back(value_at_position(panel.y, static_cast<double>(i) / steps));
    for (std::size_t i = 0; i < steps; ++i)
        cells.values.push_back(value_at_position(panel.y, (static_cast<double>(i) + 0.5) / steps));
    panel.layers.emplace_back(std::move(cells));
    return panel;
}

}  // namespace

Format format_of(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    if (extension == ".png") return Format::png;
    if (extension == ".svg") return Format::svg;
    if (extension == ".pdf") return Format::pdf;
    throw Error(ErrorKind::input, {"cannot draw into " + path.string(), "a picture is a .png, .svg or .pdf file",
                                   "Give the name one of these endings."});
}

std::string render(const Scene& scene, Format format) {
    const Layout layout = arrange(scene);
    Page page(scene.width, layout.height, format, plain_text(scene.title));
    for (std::size_t i = 0; i < scene.panels.size(); ++i)
        draw_panel(page, scene.panels[i], layout.panels[i], TickSide::left);
    if (layout.colour_bar) draw_panel(page, colour_bar_panel(*scene.colour_bar), *layout.colour_bar, TickSide::right);
    for (const PlacedSample& sample : layout.samples)
        draw_sample(page, sample);
    for (const PlacedText& text : layout.texts)
        page.text(text);
    return page.finished();
}

}  // namespace stridor::drawing
