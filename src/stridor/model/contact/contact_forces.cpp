#include "stridor/model/contact/contact_forces.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/model/sized_structure.hpp"

#include <Eigen/LU>

#include <cmath>

namespace stridor::model {

namespace {

template <int dofs>
Instant instant_of(const SizedStructure<dofs>& structure, const FrictionLaw& friction,
                   const typename SizedStructure<dofs>::Vector& u, const typename SizedStructure<dofs>::Vector& v,
                   const SurfaceMotion& surface) {
    using Vector = typename SizedStructure<dofs>::Vector;
    const typename SizedStructure<dofs>::Matrix inverse_mass = structure.mass.inverse();
    const Vector free = inverse_mass * (structure.load - structure.stiffness * u - structure.damping * v);
    const Vector from_normal = inverse_mass * structure.normal;
    const Vector from_tangent = inverse_mass * structure.tangent;
    const double nn = structure.normal.dot(from_normal);
    const double nt = structure.normal.dot(from_tangent);
    const double tt = structure.tangent.dot(from_tangent);
    require_no_painleve(nn, nt, friction);

    Instant now;
    now.acceleration = free;
    const bool is_open = structure.normal.dot(u) > 0.0 || structure.normal.dot(v) > 0.0;
    if (is_open) return now;

    const double opening = structure.normal.dot(free);
    const double w = structure.tangent.dot(v) - surface.velocity;
    if (w == 0.0) {
        const double determinant = nn * tt - nt * nt;
        const double sliding = surface.acceleration - structure.tangent.dot(free);
        now.normal_force = (-opening * tt - nt * sliding) / determinant;
        now.friction_force = (nn * sliding + nt * opening) / determinant;
        now.state = ContactState::stick;
    }
    if (now.state != ContactState::stick || !holds(friction, now.normal_force, now.friction_force)) {
        // a stuck contact that cannot hold slips against its friction force
        const double ratio = slip_ratio(friction, w != 0.0 ? slip_of(w) : slip_against(now.friction_force), w);
        now.normal_force = -opening / (nn + ratio * nt);
        now.friction_force = ratio * now.normal_force;
        now.state = ContactState::slip;
    }
    if (now.normal_force < 0.0) return {ContactState::separation, 0.0, 0.0, free};
    now.acceleration = free + from_normal * now.normal_force + from_tangent * now.friction_force;
    return now;
}

}  // namespace

void require_no_painleve(double normal_compliance, double coupling, const FrictionLaw& friction) {
    for (const Slip way : slips) {
        const double ratio = slip_ratio(friction, way);
        if (normal_compliance + ratio * coupling > 0.0) continue;
        throw Error(ErrorKind::numerical,
                    {"the contact is a Painleve configuration at mu_d = " + base::shortest(std::abs(ratio)),
                     "with so much friction no contact force keeps the surfaces closed",
                     "Lower kinetic_friction or uncouple the masses."});
    }
}

Instant instant(const Structure& structure, const Eigen::VectorXd& u, const Eigen::VectorXd& v,
                const SurfaceMotion& surface) {
    const ContactPoint& contact = only_contact(structure, "the contact at one instant");
    return with_size(dofs_of(structure), [&](auto size) {
        return instant_of<size()>({structure, contact}, contact.friction, u, v, surface);
    });
}

}  // namespace stridor::model
