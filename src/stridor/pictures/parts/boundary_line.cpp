#include "stridor/pictures/parts/boundary_line.hpp"

#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/field_axis.hpp"

#include <limits>
#include <utility>

namespace stridor::pictures {

namespace {

class EdgeLine {
public:
    explicit EdgeLine(const sweep::Study& study)
        : study_(study),
          x_edges_(cell_edges(study.x)),
          y_edges_(cell_edges(study.y)) {}

    void add(const sweep::Boundary& boundary) {
        if (!line_.x.empty()) point(line_.x.back(), std::numeric_limits<double>::quiet_NaN());
        std::vector<sweep::BoundaryVertex> vertices = boundary.vertices;
        if (boundary.form == sweep::LineForm::closed)
            vertices.push_back(vertices.front());
        else
            end(vertices.front());
        point(vertices.front().x, vertices.front().y);
        for (std::size_t k = 1; k < vertices.size(); ++k) {
            // around the corner of the cells
            const bool is_upright = vertices[k - 1].crossing == sweep::Crossing::along_x;
            const bool is_level = vertices[k - 1].crossing == sweep::Crossing::along_y;
            if (is_upright) point(vertices[k - 1].x, vertices[k].y);
            if (is_level) point(vertices[k].x, vertices[k - 1].y);
            point(vertices[k].x, vertices[k].y);
        }
        if (boundary.form == sweep::LineForm::open) end(vertices.back());
    }

    drawing::Line line() && { return std::move(line_); }

private:
    const sweep::Study& study_;
    std::vector<double> x_edges_;
    std::vector<double> y_edges_;
    drawing::Line line_{{}, {}, {drawing::ink, 0.6, drawing::Dash::solid}};

    void point(double x, double y) {
        line_.x.push_back(x);
        line_.y.push_back(y);
    }

    // the half cell from the outermost values to the frame
    void end(const sweep::BoundaryVertex& vertex) {
        const bool is_upright = vertex.crossing == sweep::Crossing::along_x;
        const bool is_level = vertex.crossing == sweep::Crossing::along_y;
        if (is_upright && vertex.y == study_.y.from) point(vertex.x, y_edges_.front());
        if (is_upright && vertex.y == study_.y.to) point(vertex.x, y_edges_.back());
        if (is_level && vertex.x == study_.x.from) point(x_edges_.front(), vertex.y);
        if (is_level && vertex.x == study_.x.to) point(x_edges_.back(), vertex.y);
    }
};

}  // namespace

drawing::Line boundary_line(const sweep::Study& study, const std::vector<sweep::Boundary>& boundaries,
                            std::size_t direction) {
    EdgeLine line(study);
    for (const sweep::Boundary& boundary : boundaries)
        if (boundary.direction == direction) line.add(boundary);
    return std::move(line).line();
}

}  // namespace stridor::pictures
