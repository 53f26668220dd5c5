#pragma once

#include "stridor/drawing/page.hpp"
#include "stridor/drawing/scene.hpp"

#include <filesystem>
#include <string>

namespace stridor::drawing {

/// The picture of a scene as the bytes of a file. The same scene gives the same bytes on the same machine.
///
/// The file looks the same on every other: the letters of an SVG are outlines, a PDF holds its font.
///
/// Throws `Error` (io) where no font is installed, memory ran out or the scene is too large for its format.
std::string render(const Scene& scene, Format format);

/// PNG, SVG or PDF, by a file's extension. Throws `Error` (input) for any other.
Format format_of(const std::filesystem::path& path);

}  // namespace stridor::drawing
