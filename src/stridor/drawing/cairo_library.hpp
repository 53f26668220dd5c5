#pragma once

// cairo and pango, opened when the first picture is drawn: linked to the program, they and the thirty libraries they
// need would be loaded at every start. Private to this folder.

#include "stridor/base/opened_library.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <pango/pangocairo.h>

namespace stridor::drawing {

/// The functions of cairo that Stridor uses, of the version it was built with: cairo_fill is `cairo().fill`.
struct Cairo {
    base::OpenedLibrary library{STRIDOR_CAIRO_LIBRARY};
    decltype(&::cairo_clip) clip = library.function("cairo_clip");
    decltype(&::cairo_close_path) close_path = library.function("cairo_close_path");
    decltype(&::cairo_create) create = library.function("cairo_create");
    decltype(&::cairo_destroy) destroy = library.function("cairo_destroy");
    decltype(&::cairo_fill) fill = library.function("cairo_fill");
    decltype(&::cairo_font_options_create) font_options_create = library.function("cairo_font_options_create");
    decltype(&::cairo_font_options_destroy) font_options_destroy = library.function("cairo_font_options_destroy");
    decltype(&::cairo_font_options_set_antialias) font_options_set_antialias =
        library.function("cairo_font_options_set_antialias");
    decltype(&::cairo_font_options_set_hint_metrics) font_options_set_hint_metrics =
        library.function("cairo_font_options_set_hint_metrics");
    decltype(&::cairo_font_options_set_hint_style) font_options_set_hint_style =
        library.function("cairo_font_options_set_hint_style");
    decltype(&::cairo_image_surface_create) image_surface_create = library.function("cairo_image_surface_create");
    decltype(&::cairo_line_to) line_to = library.function("cairo_line_to");
    decltype(&::cairo_move_to) move_to = library.function("cairo_move_to");
    decltype(&::cairo_new_sub_path) new_sub_path = library.function("cairo_new_sub_path");
    decltype(&::cairo_paint) paint = library.function("cairo_paint");
    decltype(&::cairo_pdf_surface_create_for_stream) pdf_surface_create_for_stream =
        library.function("cairo_pdf_surface_create_for_stream");
    decltype(&::cairo_pdf_surface_set_metadata) pdf_surface_set_metadata =
        library.function("cairo_pdf_surface_set_metadata");
    decltype(&::cairo_rectangle) rectangle = library.function("cairo_rectangle");
    decltype(&::cairo_restore) restore = library.function("cairo_restore");
    decltype(&::cairo_rotate) rotate = library.function("cairo_rotate");
    decltype(&::cairo_save) save = library.function("cairo_save");
    decltype(&::cairo_scale) scale = library.function("cairo_scale");
    decltype(&::cairo_set_dash) set_dash = library.function("cairo_set_dash");
    decltype(&::cairo_set_line_cap) set_line_cap = library.function("cairo_set_line_cap");
    decltype(&::cairo_set_line_join) set_line_join = library.function("cairo_set_line_join");
    decltype(&::cairo_set_line_width) set_line_width = library.function("cairo_set_line_width");
    decltype(&::cairo_set_source_rgb) set_source_rgb = library.function("cairo_set_source_rgb");
    decltype(&::cairo_status) status = library.function("cairo_status");
    decltype(&::cairo_status_to_string) status_to_string = library.function("cairo_status_to_string");
    decltype(&::cairo_stroke) stroke = library.function("cairo_stroke");
    decltype(&::cairo_surface_destroy) surface_destroy = library.function("cairo_surface_destroy");
    decltype(&::cairo_surface_finish) surface_finish = library.function("cairo_surface_finish");
    decltype(&::cairo_surface_status) surface_status = library.function("cairo_surface_status");
    decltype(&::cairo_surface_write_to_png_stream) surface_write_to_png_stream =
        library.function("cairo_surface_write_to_png_stream");
    decltype(&::cairo_svg_surface_create_for_stream) svg_surface_create_for_stream =
        library.function("cairo_svg_surface_create_for_stream");
    decltype(&::cairo_translate) translate = library.function("cairo_translate");
};

/// The functions of pango that Stridor uses, likewise, and those of GLib, which it is made with.
struct Pango {
    base::OpenedLibrary library{STRIDOR_PANGOCAIRO_LIBRARY};
    decltype(&::g_free) g_free = library.function("g_free");
    decltype(&::g_object_unref) g_object_unref = library.function("g_object_unref");
    decltype(&::g_utf8_make_valid) g_utf8_make_valid = library.function("g_utf8_make_valid");
    decltype(&::pango_attr_list_insert) attr_list_insert = library.function("pango_attr_list_insert");
    decltype(&::pango_attr_list_new) attr_list_new = library.function("pango_attr_list_new");
    decltype(&::pango_attr_list_unref) attr_list_unref = library.function("pango_attr_list_unref");
    decltype(&::pango_attr_rise_new) attr_rise_new = library.function("pango_attr_rise_new");
    decltype(&::pango_attr_size_new) attr_size_new = library.function("pango_attr_size_new");
    decltype(&::pango_attr_style_new) attr_style_new = library.function("pango_attr_style_new");
    decltype(&::pango_attr_weight_new) attr_weight_new = library.function("pango_attr_weight_new");
    decltype(&::pango_cairo_context_set_font_options) cairo_context_set_font_options =
        library.function("pango_cairo_context_set_font_options");
    decltype(&::pango_cairo_context_set_resolution) cairo_context_set_resolution =
        library.function("pango_cairo_context_set_resolution");
    decltype(&::pango_cairo_font_map_get_default) cairo_font_map_get_default =
        library.function("pango_cairo_font_map_get_default");
    decltype(&::pango_cairo_layout_line_path) cairo_layout_line_path = library.function("pango_cairo_layout_line_path");
    decltype(&::pango_cairo_show_layout_line) cairo_show_layout_line = library.function("pango_cairo_show_layout_line");
    decltype(&::pango_cairo_update_layout) cairo_update_layout = library.function("pango_cairo_update_layout");
    decltype(&::pango_context_get_metrics) context_get_metrics = library.function("pango_context_get_metrics");
    decltype(&::pango_context_load_font) context_load_font = library.function("pango_context_load_font");
    decltype(&::pango_context_set_base_dir) context_set_base_dir = library.function("pango_context_set_base_dir");
    decltype(&::pango_context_set_language) context_set_language = library.function("pango_context_set_language");
    decltype(&::pango_context_set_round_glyph_positions) context_set_round_glyph_positions =
        library.function("pango_context_set_round_glyph_positions");
    decltype(&::pango_font_description_free) font_description_free = library.function("pango_font_description_free");
    decltype(&::pango_font_description_from_string) font_description_from_string =
        library.function("pango_font_description_from_string");
    decltype(&::pango_font_description_set_size) font_description_set_size =
        library.function("pango_font_description_set_size");
    decltype(&::pango_font_map_create_context) font_map_create_context =
        library.function("pango_font_map_create_context");
    decltype(&::pango_font_metrics_get_ascent) font_metrics_get_ascent =
        library.function("pango_font_metrics_get_ascent");
    decltype(&::pango_font_metrics_get_descent) font_metrics_get_descent =
        library.function("pango_font_metrics_get_descent");
    decltype(&::pango_font_metrics_unref) font_metrics_unref = library.function("pango_font_metrics_unref");
    decltype(&::pango_language_from_string) language_from_string = library.function("pango_language_from_string");
    decltype(&::pango_layout_get_line_readonly) layout_get_line_readonly =
        library.function("pango_layout_get_line_readonly");
    decltype(&::pango_layout_line_get_extents) layout_line_get_extents =
        library.function("pango_layout_line_get_extents");
    decltype(&::pango_layout_new) layout_new = library.function("pango_layout_new");
    decltype(&::pango_layout_set_attributes) layout_set_attributes = library.function("pango_layout_set_attributes");
    decltype(&::pango_layout_set_auto_dir) layout_set_auto_dir = library.function("pango_layout_set_auto_dir");
    decltype(&::pango_layout_set_font_description) layout_set_font_description =
        library.function("pango_layout_set_font_description");
    decltype(&::pango_layout_set_single_paragraph_mode) layout_set_single_paragraph_mode =
        library.function("pango_layout_set_single_paragraph_mode");
    decltype(&::pango_layout_set_text) layout_set_text = library.function("pango_layout_set_text");
};

/// Cairo, opened once for the process. Throws `Error` (io) where this machine lacks it.
const Cairo& cairo();

/// Likewise, Pango with GLib.
const Pango& pango();

}  // namespace stridor::drawing
