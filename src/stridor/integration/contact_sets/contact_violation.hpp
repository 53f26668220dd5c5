#pragma once

#include "stridor/integration/contact_mode.hpp"
#include "stridor/integration/modal_structure.hpp"

#include <cstddef>
#include <vector>

namespace stridor::integration {

/// The limit of friction of a stuck contact. It falls once within an event, or within a step of a time stepping: limits
/// that only fall make the search for a set of states end.
enum class StickLimit { whole, fallen };

/// Largest T/N [1] of a stuck contact, without sign, that keeps it from slipping that way; one that has fallen is that
/// of the slip.
double limit_of(const model::FrictionLaw& law, model::Slip way, StickLimit limit);

/// A contact in a trial of states: what its state makes of its push (forces or impulses) and of its rates.
struct TriedContact {
    ContactMode mode = ContactMode::open;
    StickLimit limit = StickLimit::whole;
    double normal = 0.0;         // [N] or [N*s]
    double tangential = 0.0;     // likewise
    double gap_velocity = 0.0;   // [m/s] afterwards
    double slip_velocity = 0.0;  // [m/s] likewise
};

/// What pushes and rates of a trial are held against: the largest of all contacts, and the share of it that is zero.
struct TrialScale {
    double push = 0.0;      // [N] or [N*s]
    double speed = 0.0;     // [m/s]
    double rounding = 0.0;  // [1]
};

/// How far a contact is from its law, and the state that it should have instead.
struct ContactViolation {
    double size = 0.0;  // [1] of the scale; 0: it obeys
    ContactMode mode = ContactMode::open;
};

/// The laws of a touching contact, the same for every engine with several contacts:
///
///     open g' >= 0;   closed N >= 0;   slip: sign(w) is that of its state;   stick: |T| <= limit N
///
/// A contact that breaks one becomes stuck, open, stuck, or slips against T. The worse of two counts.
ContactViolation violation(const ModalContact& law, const TriedContact& contact, const TrialScale& scale);

/// The contact that is farthest from its law, the first of several.
struct WorstContact {
    std::size_t contact = 0;
    ContactViolation violation{};
};

/// Returns the worst of those that take part; a violation of size 0 if all obey. `tried` and `touches` have the shape
/// [contact].
template <typename Touches>
WorstContact worst_contact(const std::vector<ModalContact>& laws, const std::vector<TriedContact>& tried,
                           const Touches& touches, const TrialScale& scale) {
    WorstContact worst;
    for (std::size_t k = 0; k < tried.size(); ++k) {
        if (!touches[k]) continue;
        const ContactViolation here = violation(laws[k], tried[k], scale);
        if (here.size > worst.violation.size) worst = {k, here};
    }
    return worst;
}

}  // namespace stridor::integration
