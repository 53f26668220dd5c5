#pragma once

#include "stridor/integration/exact/contact_coordinates.hpp"
#include "stridor/integration/kernels/exact_kernel.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/model/laws/friction.hpp"

#include <memory>

namespace stridor::integration {

/// Prepares the contact states of a structure; `drive_frequency` [Hz] is 0 unless the drive is sinusoidal.
template <int dofs>
Flows prepare_flows(const ContactCoordinates<dofs>& coordinates, const model::FrictionLaw& friction,
                    double drive_frequency, const Kernel& loops);

extern template Flows prepare_flows<2>(const ContactCoordinates<2>&, const model::FrictionLaw&, double, const Kernel&);
extern template Flows prepare_flows<3>(const ContactCoordinates<3>&, const model::FrictionLaw&, double, const Kernel&);

/// Prepared flows, kept for the next run: cells of a chart often differ in preload, velocity or start only.
///
/// For one thread at a time. The same numbers come out whether they were kept or prepared anew.
template <int dofs>
class SizedFlows {
public:
    /// Returns the flows of these coordinates and laws, valid until the next call.
    const Flows& of(const ContactCoordinates<dofs>& coordinates, const model::FrictionLaw& friction,
                    double drive_frequency, const Kernel& loops) {
        const bool is_same =
            last_ && last_->coordinates.basis == coordinates.basis && last_->coordinates.mass == coordinates.mass &&
            last_->coordinates.damping == coordinates.damping &&
            last_->coordinates.stiffness == coordinates.stiffness && last_->coordinates.load == coordinates.load &&
            last_->friction == friction && last_->coordinates.tangent_on_gap == coordinates.tangent_on_gap &&
            last_->drive_frequency == drive_frequency;
        if (is_same) return last_->flows;
        // the memory is kept: fresh pages would take a third of the time of preparing
        if (!last_) last_ = std::make_unique<Entry>();
        *last_ = {coordinates, friction, drive_frequency, prepare_flows(coordinates, friction, drive_frequency, loops)};
        return last_->flows;
    }

private:
    struct Entry {
        ContactCoordinates<dofs> coordinates;
        model::FrictionLaw friction;
        double drive_frequency;
        Flows flows;
    };
    std::unique_ptr<Entry> last_;
};

/// Those of each size.
struct SharedFlows {
    SizedFlows<2> of_2;
    SizedFlows<3> of_3;

    /// Returns those of one size.
    template <int dofs>
    SizedFlows<dofs>& of_size() {
        if constexpr (dofs == 2)
            return of_2;
        else
            return of_3;
    }
};

}  // namespace stridor::integration
