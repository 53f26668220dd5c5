#pragma once

namespace stridor::integration {

/// The contact states with the two directions of slip told apart.
enum class ContactMode { open, stick, slip_forward, slip_backward };  // forward: w > 0
inline constexpr int contact_modes = 4;

/// Returns the other way of a slip.
constexpr ContactMode turned(ContactMode slip) {
    return slip == ContactMode::slip_forward ? ContactMode::slip_backward : ContactMode::slip_forward;
}

/// Says whether the contact slips, whichever way.
constexpr bool is_slip(ContactMode mode) {
    return mode == ContactMode::slip_forward || mode == ContactMode::slip_backward;
}

/// Returns the sign of the slip velocity of a contact that slips [1].
constexpr double sign_of(ContactMode slip) {
    return slip == ContactMode::slip_forward ? 1.0 : -1.0;
}

}  // namespace stridor::integration
