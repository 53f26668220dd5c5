#include "stridor/model/contact_forces.hpp"

#include "stridor/base/text.hpp"

namespace stridor::model {

void require_no_painleve(double normal_compliance, double coupling, double kinetic_friction) {
    if (normal_compliance - kinetic_friction * std::abs(coupling) > 0.0) return;
    throw Error(ErrorKind::numerical,
                {"the contact is a Painleve configuration at mu_d = " + base::shortest(kinetic_friction),
                 "with so much friction no contact force keeps the surfaces closed",
                 "Lower kinetic_friction or uncouple the masses."});
}

}  // namespace stridor::model
