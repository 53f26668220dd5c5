#pragma once

#include "stridor/integration/modal/modal_structure.hpp"
#include "stridor/integration/rules/contact_mode.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

/// The search for a set of contact modes that obeys all laws, the same for every engine with several contacts: the
/// contact that is farthest from its law changes, until none breaks one. A limit of friction that broke is that of the
/// slip until the search has ended, so that limits only fall. Single changes may run in a circle all the same, where a
/// contact that stuck would be pulled open and one that was open would fall: then all sets are tried.
namespace stridor::integration {

/// The limit of friction of a stuck contact. It falls once within an event, or within a step of a time stepping: limits
/// that only fall make the search for a set of states end.
enum class StickLimit { whole, fallen };

/// Returns largest T/N [1] of a stuck contact, without sign, that keeps it from slipping that way; one that has fallen
/// is that of the slip, and knows no rest. `grown` [1] is what rest has added to it.
double limit_of(const model::FrictionLaw& law, model::Slip way, StickLimit limit, double grown = 0.0);

/// A contact in a trial of states: what its state makes of its push (forces or impulses) and of its rates.
struct TriedContact {
    ContactMode mode = ContactMode::open;
    StickLimit limit = StickLimit::whole;
    double normal = 0.0;         // [N] or [N*s]
    double tangential = 0.0;     // likewise
    double gap_velocity = 0.0;   // [m/s] afterwards
    double slip_velocity = 0.0;  // [m/s] likewise
    double grown = 0.0;          // [1] what rest has added to its limit, if it stuck before
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

/// Returns the laws of a touching contact, the same for every engine with several contacts:
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

/// Returns all sets of contact modes that take one of its possible modes for each contact (shape [contact][possible]):
/// those that change the fewest of the present modes first; likewise in the order in which the modes are listed. None
/// if they are more than `most`: nobody waits for so many.
std::vector<std::vector<ContactMode>> contact_sets(const std::vector<std::vector<ContactMode>>& possible,
                                                   const std::vector<ContactMode>& present, std::size_t most = 65536);

/// Repeats a trial until it has a result, which is returned. A trial solves the present set and changes the contact
/// that is farthest from its law; it has a result if no contact breaks one, and if the set has no solution. Empty if
/// 40 changes, and 20 for each contact, were not enough.
template <typename Trial>
auto change_one_by_one(std::size_t contacts, Trial trial) {
    const std::size_t most_changes = 40 + 20 * contacts;
    decltype(trial()) result;
    for (std::size_t change = 0; change < most_changes && !result; ++change)
        result = trial();
    return result;
}

/// Tries all sets of possible modes, those nearest to the present one first, until one obeys all laws; returns whether
/// one does.
template <typename Obeys>
bool try_all_sets(const std::vector<std::vector<ContactMode>>& possible, const std::vector<ContactMode>& present,
                  Obeys obeys) {
    const std::vector<std::vector<ContactMode>> sets = contact_sets(possible, present);
    return std::any_of(sets.begin(), sets.end(), obeys);
}

}  // namespace stridor::integration
