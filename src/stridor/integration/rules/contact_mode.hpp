#pragma once

namespace stridor::integration {

/// The contact states with the two directions of slip told apart.
enum class ContactMode { open, stick, slip_forward, slip_backward };  // forward: w > 0
inline constexpr int contact_modes = 4;

/// The other way of a slip.
constexpr ContactMode turned(ContactMode slip) {
    return slip == ContactMode::slip_forward ? ContactMode::slip_backward : ContactMode::slip_forward;
}

/// Does the contact slip, whichever way?
constexpr bool is_slip(ContactMode mode) {
    return mode == ContactMode::slip_forward || mode == ContactMode::slip_backward;
}

}  // namespace stridor::integration
