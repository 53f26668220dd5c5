#pragma once

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/drawing/scene.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/recorder.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/diagram.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// Results to picture files: which scene goes where.
namespace stridor::pictures {

/// Draws a scene into a PNG, SVG or PDF file, by its extension; whoever looks sees the old file or the whole new one.
void draw(const drawing::Scene& scene, const std::filesystem::path& path);

/// Draws a scene as STEM.png and STEM.svg.
void draw_both(const drawing::Scene& scene, const std::filesystem::path& stem);

/// What a motion looks like, with a zoom ("from:to" with units; empty: chosen): Figure 5, or of several contacts of an
/// own structure each one's states (`shows_many_contacts`), for which the record needs no trace.
drawing::Scene motion_scene(const parameters::Case& c, const record::Record& record, const std::string& zoom);

/// Frequencies and growth rates of the sliding modes along a parameter.
void draw_stability(const analysis::StabilityScan& scan, const std::string& path);

/// Draws a scene as STEM with each of the endings: ".png".
void draw_each(const drawing::Scene& scene, const std::filesystem::path& stem, std::span<const std::string> endings);

/// Pictures of each ending: chart of the first quantity the study asks for, chart-QUANTITY of each further one.
void draw_charts(const sweep::SweepResult& result, const std::filesystem::path& folder,
                 std::span<const std::string> endings);

/// Pictures of each ending of a study over one axis: chart.
void draw_diagram(const sweep::SweepResult& result, const std::vector<sweep::DiagramCell>& cells,
                  const std::filesystem::path& folder, std::span<const std::string> endings);

}  // namespace stridor::pictures
