#pragma once

#include "stridor/chart/scene.hpp"
#include "stridor/chart/script.hpp"

#include <filesystem>
#include <string>

namespace stridor::chart {

/// Is gnuplot there to draw with?
bool can_draw();

/// The picture of a scene as the bytes of a file, drawn by gnuplot.
///
/// Throws `Error` (io) where gnuplot is not installed, or with gnuplot's own message where it fails.
std::string render(const Scene& scene, Format format);

/// Draws a scene into a file, PNG or SVG by its extension, under a temporary name first: whoever looks sees the old file or
/// the whole new one. Throws `Error`: input for another extension, io for what `render` throws and for a failing disk.
void draw(const Scene& scene, const std::filesystem::path& path);

}  // namespace stridor::chart
