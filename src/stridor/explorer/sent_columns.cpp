#include "stridor/explorer/sent_columns.hpp"

#include "stridor/io/simulation/simulation_tables.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/record/trace.hpp"

#include <string_view>
#include <tuple>
#include <utility>

namespace stridor::explorer {

namespace {

/// A point as the page knows it: what moves, and its weights.
struct SentPoint {
    std::string name;   // x1 and y1 of the first joint, y2 of the plate; x_lip2 and y_lip2 of a further contact
    std::string whose;  // after "displacement" and "velocity"
    std::vector<double> weights;
};

void add_points(std::vector<SentPoint>& points, const parameters::Case& c, std::size_t contact) {
    using parameters::PointAxis;
    const bool is_joint = parameters::has_plate(c);
    const bool is_first_joint = is_joint && contact == 0;
    const std::string name = parameters::contact_name(c, contact);
    const std::string ending = parameters::contact_count(c) == 1 || is_first_joint ? "1" : "_" + name;
    const std::string whose = parameters::has_one_joint(c) ? "of the " + name : "of " + name;
    points.push_back({"x" + ending, whose + (is_joint ? " along the plate" : " along the sliding direction"),
                      parameters::point_weights(c, contact, PointAxis::sliding)});
    points.push_back({"y" + ending, whose + (is_joint ? " across the plate" : " along the normal"),
                      parameters::point_weights(c, contact, PointAxis::normal)});
}

std::vector<SentPoint> points_of(const parameters::Case& c) {
    std::vector<SentPoint> points;
    for (std::size_t contact = 0; contact < parameters::contact_count(c); ++contact)
        add_points(points, c, contact);
    if (parameters::has_plate(c))
        points.push_back({"y2", "of the plate across the contact",
                          parameters::weight_of_one(c, parameters::coordinate_count(c) - 1)});
    return points;
}

void add_samples(const std::vector<double>& samples, std::vector<float>& sent) {
    for (const double value : samples)
        sent.push_back(static_cast<float>(value));
}

/// Rows of a motion with what each counts; those that count nothing are left out.
using Weights = std::vector<std::pair<std::size_t, double>>;

Weights weights_of(const std::vector<double>& rows) {
    Weights weights;
    for (std::size_t row = 0; row < rows.size(); ++row)
        if (rows[row] != 0.0) weights.emplace_back(row, rows[row]);
    return weights;
}

using Rows = std::vector<std::vector<double>> record::Trace::*;

SentColumn weighed(std::string name, std::string_view unit, std::string sentence, Rows rows, Weights weights) {
    return {std::move(name), std::string(unit), std::move(sentence),
            [rows, weights = std::move(weights)](const record::Trace& trace, std::vector<float>& sent) {
                for (std::size_t sample = 0; sample < trace.time.size(); ++sample) {
                    double sum = 0.0;
                    for (const auto& [row, weight] : weights)
                        sum += weight * (trace.*rows)[row][sample];
                    sent.push_back(static_cast<float>(sum));
                }
            }};
}

void add_motions(std::vector<SentColumn>& columns, const parameters::Case& c) {
    for (const SentPoint& point : points_of(c)) {
        const Weights weights = weights_of(point.weights);
        columns.push_back(
            weighed(point.name, "m", "displacement " + point.whose, &record::Trace::displacement, weights));
        columns.push_back(
            weighed(point.name + "_velocity", "m/s", "velocity " + point.whose, &record::Trace::velocity, weights));
    }
    for (const parameters::OwnOutput& output : parameters::outputs_of(c))
        columns.push_back(weighed("velocity_" + output.name, "m/s", "velocity of " + output.name,
                                  &record::Trace::velocity, weights_of(output.weights)));
    std::size_t number = 0;
    for (const parameters::OutlinePoint& point : parameters::outline_of(c)) {
        ++number;
        for (const auto& [axis, rows] : {std::pair("_x", &point.along), std::pair("_y", &point.across)})
            if (Weights weights = weights_of(*rows); !weights.empty())
                columns.push_back(weighed("outline_" + std::to_string(number) + axis, "m",
                                          "displacement of a point of the outline", &record::Trace::displacement,
                                          std::move(weights)));
    }
}

}  // namespace

std::vector<SentColumn> sent_columns(const parameters::Case& c) {
    std::vector<SentColumn> columns;
    add_motions(columns, c);
    columns.push_back({std::string(record::surface_column.name), std::string(record::surface_column.unit),
                       std::string(record::surface_column.sentence),
                       [](const record::Trace& trace, std::vector<float>& sent) {
                           add_samples(trace.*record::surface_column.samples, sent);
                       }});
    const std::size_t contacts = parameters::contact_count(c);
    for (std::size_t contact = 0; contact < contacts; ++contact)
        for (const record::ContactColumn& column : record::contact_columns)
            columns.push_back(
                {std::string(column.name) + record::contact_ending(contact, contacts), std::string(column.unit),
                 std::string(column.sentence),
                 [member = column.samples, contact](const record::Trace& trace, std::vector<float>& sent) {
                     add_samples(trace.contacts[contact].*member, sent);
                 }});
    return columns;
}

}  // namespace stridor::explorer
