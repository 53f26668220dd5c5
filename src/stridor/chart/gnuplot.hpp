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

/// PNG or SVG, by a file's extension. Throws `Error` (input) for any other.
Format format_of(const std::filesystem::path& path);

}  // namespace stridor::chart
