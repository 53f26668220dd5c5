#pragma once

#include "stridor/integration/rules/contact_mode.hpp"
#include "stridor/model/contact_state.hpp"
#include "stridor/model/laws/friction.hpp"

namespace stridor::integration {

/// Returns the mode of a contact that slips one way.
constexpr ContactMode slip_mode(model::Slip way) {
    return way == model::Slip::forward ? ContactMode::slip_forward : ContactMode::slip_backward;
}

/// Returns the way in which a contact slips that does.
constexpr model::Slip way_of(ContactMode mode) {
    return mode == ContactMode::slip_forward ? model::Slip::forward : model::Slip::backward;
}

/// Returns the contact state of a mode.
constexpr model::ContactState contact_of(ContactMode mode) {
    if (is_slip(mode)) return model::ContactState::slip;
    return mode == ContactMode::stick ? model::ContactState::stick : model::ContactState::separation;
}

}  // namespace stridor::integration
