#include "stridor/drawing/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

}  // namespace stridor::drawing
