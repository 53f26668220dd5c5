#pragma once

#include "stridor/drawing/layout.hpp"
#include "stridor/drawing/page.hpp"
#include "stridor/drawing/scene.hpp"

#include <filesystem>
#include <string>

namespace stridor::drawing {

/// The side of a panel on which its y ticks stand.
enum class TickSide { left, right };

/// Draws one panel of a scene: its grid, its layers, its frame with the ticks, and its notes over all of them. The
/// numbers of the ticks and the titles are texts of the layout.
void draw_panel(Page& page, const Panel& panel, const PlacedPanel& placed, TickSide side);

/// Draws a sample of the legend.
void draw_sample(Page& page, const PlacedSample& placed);

/// Returns the picture of a scene as the bytes of a file. The same scene gives the same bytes on the same machine.
///
/// The file looks the same on every machine: the letters of an SVG are outlines, a PDF holds its font.
///
/// Throws `Error` (io) if no font is installed, memory runs out or the scene is too large for its format.
std::string render(const Scene& scene, Format format);

/// Returns PNG, SVG or PDF, by a file's extension. Throws `Error` (input) for any other.
Format format_of(const std::filesystem::path& path);

}  // namespace stridor::drawing
