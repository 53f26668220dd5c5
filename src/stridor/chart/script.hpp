#pragma once

#include "stridor/chart/scene.hpp"

#include <string>

namespace stridor::chart {

enum class Format { png, svg };

/// Dots per inch of PNG files; SVG has no dots and is laid out at 96 to the inch, as browsers do.
inline constexpr double png_resolution = 200.0;

/// The gnuplot script of a scene, with all data inside and no file name: it draws to standard output.
///
/// The same scene gives the same bytes. No text of the scene can act as a command or as markup: strings stand in single
/// quotes, line breaks become blanks, and every character that enhanced text mode knows is escaped.
std::string script(const Scene& scene, Format format);

/// A text as a gnuplot string in enhanced mode, with its quotes.
std::string gnuplot_string(const Text& text);

}  // namespace stridor::chart
