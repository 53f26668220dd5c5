#include "stridor/pictures/parts/category_colours.hpp"

#include "stridor/drawing/palette.hpp"

namespace stridor::pictures {

using drawing::Colour;
using drawing::Fill;
using drawing::Texture;
using drawing::white;

Fill category_fill(classification::Category category) {
    using classification::Category;
    switch (category) {
        case Category::none:
            return {{0xE6, 0xE6, 0xE6}, Texture::none, {}};
        case Category::squeak:
            return {{0xDD, 0xAA, 0x33}, Texture::dots, {0x7A, 0x55, 0x00}};
        case Category::squeal:
            return {{0xBB, 0x55, 0x66}, Texture::rising, {0xE8, 0xB4, 0xBC}};
        case Category::creak:
            return {{0x00, 0x44, 0x88}, Texture::falling, {0x6F, 0x9C, 0xCC}};
        case Category::undecided:
            break;
    }
    return {white, Texture::dots, {0x66, 0x66, 0x66}};
}

Fill stuck_fill() {
    return {{0xC4, 0xCC, 0xD4}, Texture::none, {}};
}

Fill locked_fill() {
    return {{0x9A, 0xA2, 0xAB}, Texture::crossed, {0x4A, 0x52, 0x5C}};
}

Fill failed_fill() {
    return {white, Texture::crossed, {0x88, 0x88, 0x88}};
}

Colour state_colour(model::ContactState state) {
    switch (state) {
        case model::ContactState::slip:
            return {0x88, 0xCC, 0xEE};
        case model::ContactState::stick:
            return {0x7A, 0x7A, 0x00};
        case model::ContactState::separation:
            break;
    }
    return {0x30, 0x10, 0x30};
}

}  // namespace stridor::pictures
