#include "stridor/drawing/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace stridor::drawing {

namespace {

// viridis (N. J. Smith and S. van der Walt, CC0) at equal distances
constexpr std::array<Colour, 11> viridis{{{0x44, 0x01, 0x54},
                                          {0x48, 0x25, 0x76},
                                          {0x41, 0x44, 0x87},
                                          {0x35, 0x5F, 0x8D},
                                          {0x2A, 0x78, 0x8E},
                                          {0x21, 0x91, 0x8C},
                                          {0x22, 0xA8, 0x84},
                                          {0x44, 0xBF, 0x70},
                                          {0x7A, 0xD1, 0x51},
                                          {0xBD, 0xDF, 0x26},
                                          {0xFD, 0xE7, 0x25}}};

std::uint8_t mix(std::uint8_t from, std::uint8_t to, double share) {
    return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
}

Colour mix(Colour from, Colour to, double share) {
    return {mix(from.red, to.red, share), mix(from.green, to.green, share), mix(from.blue, to.blue, share)};
}

// sRGB transfer function (IEC 61966-2-1)
double linear(std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// a piece of the diagonal number k: y = slope x + k distance
struct Piece {
    long number = 0;
    double from = 0.0;  // [mm] in x
    double to = 0.0;
};

constexpr double touching = 1e-6;  // [mm] ends this close are one point

// diagonals through one rectangle, slope +-1
void add_pieces(std::vector<Piece>& pieces, const Rectangle& box, double slope, double distance) {
    // y - slope x over the rectangle
    const double lowest = box.bottom - (slope > 0.0 ? box.right : -box.left);
    const double highest = box.top - (slope > 0.0 ? box.left : -box.right);
    for (long k = std::lround(std::ceil(lowest / distance)); static_cast<double>(k) * distance <= highest; ++k) {
        const double offset = static_cast<double>(k) * distance;
        const double at_bottom = (box.bottom - offset) / slope;
        const double at_top = (box.top - offset) / slope;
        const double from = std::max(box.left, std::min(at_bottom, at_top));
        const double to = std::min(box.right, std::max(at_bottom, at_top));
        if (from < to) pieces.push_back({k, from, to});
    }
}

// pieces of one diagonal that touch become one line
std::vector<Segment> joined(std::vector<Piece> pieces, double slope, double distance) {
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
        return a.number != b.number ? a.number < b.number : a.from < b.from;
    });
    std::vector<Piece> whole;
    for (const Piece& piece : pieces)
        if (!whole.empty() && whole.back().number == piece.number && piece.from <= whole.back().to + touching)
            whole.back().to = std::max(whole.back().to, piece.to);
        else
            whole.push_back(piece);
    std::vector<Segment> lines;
    for (const Piece& piece : whole) {
        const double offset = static_cast<double>(piece.number) * distance;
        lines.push_back({piece.from, slope * piece.from + offset, piece.to, slope * piece.to + offset});
    }
    return lines;
}

void add_diagonals(Pattern& pattern, std::span<const Rectangle> area, double slope, double spacing) {
    const double distance = spacing * std::numbers::sqrt2;
    std::vector<Piece> pieces;
    for (const Rectangle& box : area)
        add_pieces(pieces, box, slope, distance);
    const std::vector<Segment> lines = joined(std::move(pieces), slope, distance);
    pattern.lines.insert(pattern.lines.end(), lines.begin(), lines.end());
}

// a staggered lattice; a dot belongs to the rectangle that holds it, its left and lower sides included
void add_dots(Pattern& pattern, const Rectangle& box, double spacing) {
    for (double row = std::ceil(box.bottom / spacing); row * spacing < box.top; row += 1.0) {
        const double shift = std::fmod(std::abs(row), 2.0) == 0.0 ? 0.0 : 0.5;
        for (double k = std::ceil(box.left / spacing - shift); (k + shift) * spacing < box.right; k += 1.0)
            pattern.dots.push_back({(k + shift) * spacing, row * spacing});
    }
}

}  // namespace

std::span<const Colour> sequential_stops() {
    return viridis;
}

Colour sequential(double share) {
    const double place = std::clamp(share, 0.0, 1.0) * (viridis.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), viridis.size() - 2);
    return mix(viridis[below], viridis[below + 1], place - static_cast<double>(below));
}

Colour tint(Colour colour, double share) {
    return mix(white, colour, std::clamp(share, 0.0, 1.0));
}

double lightness(Colour colour) {
    const double Y = 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
    return Y > 216.0 / 24389.0 ? 116.0 * std::cbrt(Y) - 16.0 : 24389.0 / 27.0 * Y;
}

Colour text_colour_on(Colour ground) {
    return lightness(ground) > 55.0 ? ink : white;
}

std::string hex(Colour colour) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string text = "#";
    for (const std::uint8_t channel : {colour.red, colour.green, colour.blue}) {
        text += digits[channel >> 4U];
        text += digits[channel & 0xFU];
    }
    return text;
}

Pattern pattern(Texture texture, std::span<const Rectangle> area, double spacing) {
    Pattern result;
    if (texture == Texture::rising || texture == Texture::crossed) add_diagonals(result, area, 1.0, spacing);
    if (texture == Texture::falling || texture == Texture::crossed) add_diagonals(result, area, -1.0, spacing);
    if (texture == Texture::dots)
        for (const Rectangle& box : area)
            add_dots(result, box, spacing);
    return result;
}

}  // namespace stridor::drawing
