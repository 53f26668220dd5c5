#include "stridor/drawing/lettering.hpp"

#include "stridor/base/error.hpp"
#include "stridor/drawing/scene.hpp"

#include <cairo.h>
#include <pango/pangocairo.h>

#include <memory>

#if defined(__SANITIZE_ADDRESS__)
#    define STRIDOR_ADDRESS_SANITIZER
#elif defined(__has_feature)
#    if __has_feature(address_sanitizer)
#        define STRIDOR_ADDRESS_SANITIZER
#    endif
#endif

#ifdef STRIDOR_ADDRESS_SANITIZER
// fontconfig keeps its patterns for the whole run behind offsets, which the leak checker does not take for pointers
extern "C" const char* __lsan_default_suppressions() {  // NOLINT
    return "leak:libfontconfig\n";
}
extern "C" const char* __lsan_default_options() {  // NOLINT
    return "print_suppressions=0";
}
#endif

namespace stridor::drawing {

namespace {

struct CairoRelease {
    void operator()(gpointer object) const { g_object_unref(object); }
    void operator()(PangoAttrList* list) const { pango_attr_list_unref(list); }
    void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }
    void operator()(PangoFontMetrics* metrics) const { pango_font_metrics_unref(metrics); }
    void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
    void operator()(char* text) const { g_free(text); }
};

template <typename Thing>
using Held = std::unique_ptr<Thing, CairoRelease>;

// letters of one shape at every size and resolution, whatever language the user's is
Held<PangoContext> context_for_paper() {
    PangoFontMap* fonts = pango_cairo_font_map_get_default();
    Held<PangoContext> context(pango_font_map_create_context(fonts));
    const Held<cairo_font_options_t> options(cairo_font_options_create());
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(context.get(), options.get());
    pango_cairo_context_set_resolution(context.get(), 72.0);
    pango_context_set_round_glyph_positions(context.get(), FALSE);
    pango_context_set_language(context.get(), pango_language_from_string("en"));
    pango_context_set_base_dir(context.get(), PANGO_DIRECTION_LTR);
    return context;
}

void add_attribute(PangoAttrList* list, PangoAttribute* attribute, std::size_t from, std::size_t to) {
    attribute->start_index = static_cast<guint>(from);
    attribute->end_index = static_cast<guint>(to);
    pango_attr_list_insert(list, attribute);
}

void add_style(PangoAttrList* list, TextStyle style, double size, std::size_t from, std::size_t to) {
    constexpr double small = 0.75;  // of the letters of an index
    const auto units = [&](double ems) { return static_cast<int>(ems * size * PANGO_SCALE); };
    switch (style) {
        case TextStyle::plain:
            return;
        case TextStyle::italic:
            return add_attribute(list, pango_attr_style_new(PANGO_STYLE_ITALIC), from, to);
        case TextStyle::bold:
            return add_attribute(list, pango_attr_weight_new(PANGO_WEIGHT_BOLD), from, to);
        case TextStyle::subscript:
        case TextStyle::superscript:
            add_attribute(list, pango_attr_size_new(units(small)), from, to);
            add_attribute(list, pango_attr_rise_new(units(style == TextStyle::subscript ? -0.18 : 0.36)), from, to);
    }
}

// one line of letters
struct SetLine {
    Held<PangoContext> context;
    Held<PangoLayout> layout;
    double drop = 0.0;  // [pt] from the middle of its height down to its baseline

    SetLine(const StyledText& text, double size)
        : context(context_for_paper()),
          layout(pango_layout_new(context.get())) {
        const Held<PangoFontDescription> font(pango_font_description_from_string("DejaVu Sans,sans-serif"));
        pango_font_description_set_size(font.get(), static_cast<int>(size * PANGO_SCALE));
        if (!Held<PangoFont>(pango_context_load_font(context.get(), font.get())))
            throw Error(ErrorKind::io, {"no font is installed", "figures have text",
                                        "Install one, on Debian with: apt install fonts-dejavu-core"});
        pango_layout_set_font_description(layout.get(), font.get());
        pango_layout_set_auto_dir(layout.get(), FALSE);
        pango_layout_set_single_paragraph_mode(layout.get(), TRUE);
        std::string letters;
        const Held<PangoAttrList> styles(pango_attr_list_new());
        for (const TextRun& run : text.runs) {
            const std::size_t from = letters.size();
            letters += drawable(run.text);
            add_style(styles.get(), run.style, size, from, letters.size());
        }
        pango_layout_set_text(layout.get(), letters.data(), static_cast<int>(letters.size()));
        pango_layout_set_attributes(layout.get(), styles.get());
        const Held<PangoFontMetrics> metrics(pango_context_get_metrics(context.get(), font.get(), nullptr));
        drop = 0.5 * (pango_font_metrics_get_ascent(metrics.get()) - pango_font_metrics_get_descent(metrics.get())) /
               PANGO_SCALE;
    }

    PangoLayoutLine* letters() const { return pango_layout_get_line_readonly(layout.get(), 0); }
};

bool is_beside_equals(const std::string& text, std::size_t blank) {
    return text[blank + 1] == '=' || (blank > 0 && text[blank - 1] == '=');
}

// a text in pieces that must stay together, each with its trailing blank
std::vector<StyledText> words_of(const StyledText& text) {
    std::vector<StyledText> words;
    bool is_open = false;
    for (const TextRun& run : text.runs)
        for (std::size_t from = 0; from < run.text.size();) {
            std::size_t blank = run.text.find(' ', from);
            // "F = 20 N" stays with its sign
            while (blank != std::string::npos && is_beside_equals(run.text, blank))
                blank = run.text.find(' ', blank + 1);
            const std::size_t to = blank == std::string::npos ? run.text.size() : blank + 1;
            if (!is_open) words.emplace_back();
            words.back().runs.push_back({run.text.substr(from, to - from), run.style});
            is_open = blank == std::string::npos;
            from = to;
        }
    return words;
}

// one by one, however many bytes each has
std::vector<StyledText> letters_of(const StyledText& text) {
    std::vector<StyledText> letters;
    for (const TextRun& run : text.runs)
        for (std::size_t from = 0, to = 0; from < run.text.size(); from = to) {
            for (++to; to < run.text.size() && (static_cast<unsigned char>(run.text[to]) & 0xC0U) == 0x80U;)
                ++to;
            letters.emplace_back(std::string_view(run.text).substr(from, to - from), run.style);
        }
    return letters;
}

}  // namespace

std::string drawable(std::string_view text) {
    const Held<char> valid(g_utf8_make_valid(text.data(), static_cast<gssize>(text.size())));
    std::string letters(valid.get());
    for (char& c : letters)
        if (static_cast<unsigned char>(c) < 0x20U || c == 0x7f) c = ' ';
    // U+FFFE and U+FFFF, which no XML may hold
    for (const std::string_view none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})
        for (std::size_t at = letters.find(none); at != std::string::npos; at = letters.find(none))
            letters.replace(at, none.size(), "\xEF\xBF\xBD");
    return letters;
}

double text_width(const StyledText& text, double size) {
    const SetLine line(text, size);
    PangoRectangle extent;
    pango_layout_line_get_extents(line.letters(), nullptr, &extent);
    return extent.width * millimetres_per_point / PANGO_SCALE;
}

std::vector<StyledText> wrapped(const StyledText& text, double size, double width) {
    std::vector<StyledText> lines;
    const auto add = [&](const StyledText& piece) {
        if (lines.empty() || text_width(lines.back() + piece, size) > width)
            lines.push_back(piece);
        else
            lines.back() = lines.back() + piece;
    };
    for (const StyledText& word : words_of(text)) {
        if (text_width(word, size) <= width) {
            add(word);
            continue;
        }
        for (const StyledText& letter : letters_of(word))
            if (plain_text(letter) == " " && !lines.empty())
                lines.back() = lines.back() + letter;
            else
                add(letter);
    }
    return lines;
}

TextExtent note_extent(const StyledText& text, double size) {
    const double em = size * millimetres_per_point;
    return {text_width(text, size) + 0.6 * em, 1.4 * em};
}

void draw_letters(cairo_t* page, const StyledText& text, double size, Letters letters) {
    const SetLine line(text, size);
    pango_cairo_update_layout(page, line.layout.get());
    cairo_move_to(page, 0.0, line.drop);
    if (letters == Letters::glyphs) return pango_cairo_show_layout_line(page, line.letters());
    pango_cairo_layout_line_path(page, line.letters());
    cairo_fill(page);
}

}  // namespace stridor::drawing
