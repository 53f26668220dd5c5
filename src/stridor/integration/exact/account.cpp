#include "stridor/integration/exact/account.hpp"

#include <algorithm>

namespace stridor::integration {

namespace {

// weights the nodes of whole steps and adds the parts
double integral(const Flow& flow, const Lanes& full, const Lanes& part) {
    double sum = 0.0;
    double rest = 0.0;
    for (int i = 0; i < lanes; ++i) {
        sum += flow.quadrature.weight.at[i] * full.at[i];
        rest += part.at[i];
    }
    return sum * flow.step + rest;
}

void add_velocities(Totals& sum, const Flows& flows, const Flow& flow, const Sums& full, const Sums& part) {
    int k = 0;
    for (int j = 0; j < flow.velocity_count; ++j)
        for (int i = 0; i <= j; ++i, ++k) {
            const double both = (i == j ? 1.0 : 2.0) * integral(flow, full.product[k], part.product[k]);
            sum.dashpot_loss += flows.damping[i][j] * both;
            for (int dof = 0; dof < flows.dofs; ++dof)
                sum.square_time[dof] += flows.basis[dof][i] * flows.basis[dof][j] * both;
        }
    for (int dof = 0; dof < flows.dofs; ++dof)
        for (int i = 0; i < lanes; ++i)
            sum.peak_square[dof] =
                std::max({sum.peak_square[dof], full.peak[body_of(dof)].at[i], part.peak[body_of(dof)].at[i]});
}

}  // namespace

Totals totals(const Flows& flows, const Account& account) {
    Totals sum;
    for (int m = 0; m < contact_modes; ++m) {
        const Flow& flow = flows.flow[m];
        const Sums& full = account.full[m];
        const Sums& part = account.part[m];
        add_velocities(sum, flows, flow, full, part);
        const double on_surface = integral(flow, full.on_surface, part.on_surface);
        if (flow.mode == ContactMode::stick) sum.drive_work += on_surface;
        if (!is_slip(flow.mode)) continue;
        const double friction = flows.slip_ratio[m];
        sum.drive_work += friction * on_surface;
        sum.friction_loss -= friction * integral(flow, full.on_slip, part.on_slip);
    }
    sum.largest_force = account.largest_force;
    // squares add up to a negative number by rounding only
    for (double& square : sum.square_time)
        square = std::max(square, 0.0);
    return sum;
}

void add(Totals& sum, const Totals& more, double factor) {
    for (int dof = 0; dof < most_coordinates; ++dof) {
        sum.square_time[dof] += factor * more.square_time[dof];
        sum.peak_square[dof] = std::max(sum.peak_square[dof], more.peak_square[dof]);
    }
    sum.dashpot_loss += factor * more.dashpot_loss;
    sum.friction_loss += factor * more.friction_loss;
    sum.drive_work += factor * more.drive_work;
    sum.largest_force = std::max(sum.largest_force, more.largest_force);
}

}  // namespace stridor::integration
