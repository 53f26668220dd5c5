#pragma once

#include <array>
#include <string_view>

namespace stridor::model {

/// What the contact does at one instant.
enum class ContactState {
    slip,        // closed, w != 0, T = -mu_d N sign(w)
    stick,       // closed, w = 0, |T| <= mu_s N
    separation,  // open, N = T = 0
};

inline constexpr int contact_states = 3;
inline constexpr std::array<std::string_view, contact_states> contact_state_names{"slip", "stick", "separation"};

/// Returns the state's place in arrays of shape [contact_states].
constexpr std::size_t index_of(ContactState state) {
    return static_cast<std::size_t>(state);
}

}  // namespace stridor::model
