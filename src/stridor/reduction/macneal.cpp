// MacNeal: with the free modes K Phi = M Phi Lambda, Phi' M Phi = 1, and forces f at the boundary b,
//
//     u_b = Phi_b q + G f,   G = (K^-1)_bb - Phi_b Lambda^-1 Phi_b',   q'' + Lambda q = Phi_b' f
//
// G is what the modes left out give way; their inertia is neglected. With f = G^-1 (b - Phi_b q) and the coordinates
// (b, q)
//
//     K_r = |  G^-1          -G^-1 Phi_b                  |      M_r = | 0  0 |
//           | -Phi_b' G^-1   Lambda + Phi_b' G^-1 Phi_b   |            | 0  1 |
//
// Inside, u_i = Phi_i q + (Psi (K^-1)_bb - Phi_i Lambda^-1 Phi_b') f.

#include "stridor/reduction/macneal.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/base/error.hpp"

#include <fmt/format.h>

namespace stridor::reduction {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double nothing_left = 1e-9;  // [1] of the flexibility of a row: as good as rounding

// with a unit diagonal of what it is inverse to; nothing where it is singular
std::optional<MatrixXd> inverse_of(const MatrixXd& matrix, const VectorXd& diagonal) {
    const VectorXd scale = diagonal.cwiseSqrt().cwiseInverse();
    const MatrixXd scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
    const Eigen::LDLT<MatrixXd> factor(scaled);
    if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > nothing_left)) return std::nullopt;
    const MatrixXd inverse = factor.solve(MatrixXd::Identity(matrix.rows(), matrix.cols()));
    return MatrixXd(scale.asDiagonal() * (0.5 * (inverse + inverse.transpose())) * scale.asDiagonal());
}

}  // namespace

Reduction macneal(const CondensedPart& condensed, const ReductionRequest& request) {
    const ElasticPart& part = condensed.part();
    const auto solver = condensed.solver({});
    const auto flexibility = inverse_of(condensed.stiffness(), condensed.stiffness().diagonal());
    if (!solver || !flexibility)
        base::refuse("the part can move freely", "MacNeal's reduction needs the flexibility of its boundary",
                     "Hold it by a support, or reduce it by Craig-Bampton.");
    const Index wanted = request.below > 0.0
                             ? modes_below(part.stiffness, part.mass, request.below, condensed.linear_solver())
                             : request.modes;
    const Modes modes = lowest_modes(part.stiffness, part.mass, wanted, *solver, condensed.linear_solver());
    const MatrixXd at_boundary = modes.shapes(condensed.parting().boundary, Eigen::all);  // Phi_b
    const MatrixXd carried = modes.squared.cwiseInverse().asDiagonal() * at_boundary.transpose();
    const MatrixXd residual = *flexibility - at_boundary * carried;
    const auto rigidity = inverse_of(residual, flexibility->diagonal());
    if (!rigidity)
        base::refuse(fmt::format("{} modes leave nothing to give way at the boundary", modes.squared.size()),
                     "MacNeal's reduction needs what the modes left out give way there",
                     "Keep fewer modes, or reduce it by Craig-Bampton.");

    Reduction reduction = opened_reduction(part, request, modes);
    reduction.method = ReductionMethod::macneal;
    reduction.solver = condensed.linear_solver();
    reduction.inertia = BoundaryInertia::massless;
    const Index boundary = reduction.boundary_rows;
    const Index kept = modes.squared.size();
    MatrixXd stiffness(boundary + kept, boundary + kept);
    const MatrixXd held = *rigidity * at_boundary;
    stiffness << *rigidity, -held, -held.transpose(), at_boundary.transpose() * held;
    stiffness.bottomRightCorner(kept, kept).diagonal() += modes.squared;
    reduction.part.stiffness = MatrixXd(0.5 * (stiffness + stiffness.transpose())).sparseView(0.0, 0.0);
    VectorXd inertia = VectorXd::Zero(boundary + kept);
    inertia.tail(kept).setOnes();
    reduction.part.mass = MatrixXd(inertia.asDiagonal()).sparseView(0.0, 0.0);
    if (part.damping.rows() != 0) {
        MatrixXd damping = MatrixXd::Zero(boundary + kept, boundary + kept);
        damping.bottomRightCorner(kept, kept) = modes.shapes.transpose() * (part.damping * modes.shapes);
        reduction.part.damping = MatrixXd(0.5 * (damping + damping.transpose())).sparseView(0.0, 0.0);
    }

    reduction.recovery.resize(static_cast<Index>(request.recovered.size()), boundary + kept);
    for (std::size_t k = 0; k < request.recovered.size(); ++k) {
        const Index row = request.recovered[k];
        const Index place = condensed.parting().place[static_cast<std::size_t>(row)];
        const bool is_boundary = condensed.parting().is_boundary[static_cast<std::size_t>(row)] != 0;
        const Eigen::RowVectorXd shape = modes.shapes.row(row);
        const Eigen::RowVectorXd gives_way = is_boundary ? Eigen::RowVectorXd(flexibility->row(place))
                                                         : condensed.constraint().row(place) * *flexibility;
        const Eigen::RowVectorXd follows = (gives_way - shape * carried) * *rigidity;
        reduction.recovery.row(static_cast<Index>(k)) << follows, shape - follows * at_boundary;
    }
    expect_finite(reduction);
    return reduction;
}

}  // namespace stridor::reduction
