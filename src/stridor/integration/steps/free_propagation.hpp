#pragma once

#include "stridor/integration/modal/modal_structure.hpp"

#include <Eigen/Core>

#include <vector>

namespace stridor::integration {

/// A structure's motion over one time step h under forces that do not change in it, exact:
///
///     q(h) = Eqq q + Eqv v + Fq (f + r),   v(h) = Evq q + Evv v + Fv (f + r)
///
/// r are contact forces in modal coordinates. Each is a number per mode where damping is diagonal, else a matrix.
/// They are sums of the power series of exp(A h) and of its integral, doubled until the step is whole.
class FreePropagation {
public:
    FreePropagation(const ModalStructure& structure, double step);

    /// Moves q and v [1/s] by one step under the load alone. Their shape is [mode]; what stands behind is left alone.
    void advance(std::vector<double>& q, std::vector<double>& v) const;

    /// Adds to their end what contact forces r [N/√kg] do in a step.
    void push(const std::vector<double>& r, std::vector<double>& q, std::vector<double>& v) const;

    /// Returns what constant contact forces change of the contacts' rates at the end of a step [m/s/N]: rows and
    /// columns as `ContactRowPlan`.
    Eigen::MatrixXd response() const;

private:
    void prepare_modes(double step);
    void prepare_whole(double step);

    const ModalStructure& structure_;
    // of diagonal damping, shape [mode]
    std::vector<double> qq_, qv_, vq_, vv_, q_load_, v_load_, q_push_, v_push_;
    // else of the state (q, v), shape [2 mode][2 mode], [2 mode], [2 mode][mode]
    Eigen::MatrixXd state_;
    Eigen::VectorXd load_;
    Eigen::MatrixXd push_;
    mutable Eigen::VectorXd before_, after_;
};

}  // namespace stridor::integration
