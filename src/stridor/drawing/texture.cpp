#include "stridor/drawing/texture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stridor::drawing {

namespace {

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
