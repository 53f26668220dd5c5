#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/recorder.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/diagram.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Writes results to picture files.
namespace stridor::pictures {

/// A user's wishes for the sheet of a picture.
struct Sheet {
    std::optional<std::string> title{};  // in the place of the picture's own; empty: none is printed
    std::optional<double> width{};       // [mm]
};

/// Returns a scene on a sheet. Letters keep their size, so that a narrow picture has fewer of them side by side and
/// gets higher. Throws `Error` (input) for a width on which texts would touch or leave the sheet, with the least width
/// that works.
drawing::Scene on_sheet(drawing::Scene scene, const Sheet& sheet);

/// Draws a scene into a PNG, SVG or PDF file, by its extension. The file is always the old one or the whole new one.
void draw(const drawing::Scene& scene, const std::filesystem::path& path, const Sheet& sheet = {});

/// Draws a scene as STEM.png and STEM.svg.
void draw_both(const drawing::Scene& scene, const std::filesystem::path& stem, const Sheet& sheet = {});

/// Draws a motion, with a zoom ("from:to" with units; empty: chosen): Figure 5, or for several contacts of an own
/// structure each one's states (`shows_many_contacts`), for which the record needs no trace.
drawing::Scene motion_scene(const parameters::Case& c, const record::Record& record, const std::string& zoom);

/// Draws a scene as STEM with each of the endings, such as ".png".
void draw_each(const drawing::Scene& scene, const std::filesystem::path& stem, std::span<const std::string> endings,
               const Sheet& sheet = {});

/// Draws pictures with each ending: chart for the study's first quantity, chart-QUANTITY for each further one.
void draw_charts(const sweep::SweepResult& result, const std::filesystem::path& folder,
                 std::span<const std::string> endings, const Sheet& sheet = {});

/// Draws pictures with each ending of a study over one axis: chart.
void draw_diagram(const sweep::SweepResult& result, const std::vector<sweep::DiagramCell>& cells,
                  const std::filesystem::path& folder, std::span<const std::string> endings, const Sheet& sheet = {});

}  // namespace stridor::pictures
