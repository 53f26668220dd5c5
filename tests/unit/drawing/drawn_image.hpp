#pragma once

#include "stridor/drawing/page.hpp"

#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <ostream>
#include <string>
#include <utility>

namespace stridor::drawing {

inline constexpr Colour red{200, 10, 20};
inline constexpr Colour blue{10, 20, 200};

inline std::ostream& operator<<(std::ostream& out, const Colour& colour) {
    return out << int{colour.red} << " " << int{colour.green} << " " << int{colour.blue};
}

/// The dots of a PNG, asked for by their place on the paper.
class DrawnImage {
public:
    explicit DrawnImage(const std::string& png) {
        std::string_view rest = png;
        image_.reset(cairo_image_surface_create_from_png_stream(take, &rest));
        EXPECT_EQ(cairo_surface_status(image_.get()), CAIRO_STATUS_SUCCESS);
    }

    int width() const { return cairo_image_surface_get_width(image_.get()); }
    int height() const { return cairo_image_surface_get_height(image_.get()); }

    /// The colour at a place [mm].
    Colour at(double x, double y) const {
        return dot(static_cast<int>(x * scale), height() - 1 - static_cast<int>(y * scale));
    }

    /// The smallest rectangle that holds every dot that is not white [mm].
    Rectangle inked() const {
        Rectangle area{1e9, -1e9, 1e9, -1e9};
        for (int row = 0; row < height(); ++row)
            for (int column = 0; column < width(); ++column)
                if (!(dot(column, row) == Colour{255, 255, 255})) {
                    area.left = std::min(area.left, column / scale);
                    area.right = std::max(area.right, (column + 1) / scale);
                    area.top = std::max(area.top, (height() - row) / scale);
                    area.bottom = std::min(area.bottom, (height() - row - 1) / scale);
                }
        return area;
    }

private:
    static constexpr double scale = png_resolution / 25.4;  // [1/mm] dots

    struct Destroy {
        void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    };
    std::unique_ptr<cairo_surface_t, Destroy> image_;

    Colour dot(int column, int row) const {
        const unsigned char* line = cairo_image_surface_get_data(image_.get()) +
                                    static_cast<std::ptrdiff_t>(row) * cairo_image_surface_get_stride(image_.get());
        std::uint32_t rgb = 0;
        std::memcpy(&rgb, line + static_cast<std::ptrdiff_t>(column) * 4, 4);
        return {static_cast<std::uint8_t>(rgb >> 16U), static_cast<std::uint8_t>(rgb >> 8U),
                static_cast<std::uint8_t>(rgb)};
    }

    static cairo_status_t take(void* from, unsigned char* bytes, unsigned int count) {
        std::string_view& rest = *static_cast<std::string_view*>(from);
        if (rest.size() < count) return CAIRO_STATUS_READ_ERROR;
        std::memcpy(bytes, rest.data(), count);
        rest.remove_prefix(count);
        return CAIRO_STATUS_SUCCESS;
    }
};

}  // namespace stridor::drawing
