#pragma once

#include "stridor/model/friction/coulomb.hpp"
#include "stridor/model/friction/directional.hpp"
#include "stridor/parameters/case.hpp"

#include <variant>

/// Friction of a contact. A law is a struct of its numbers and two functions; the engines call these and know no law.
///
/// The laws here are state-wise: their coefficients do not change as long as the contact sticks, or slips one way. The
/// motion within a contact state is linear with them, which is what the exact engine solves. A new one is a file pair
/// beside `coulomb` and its name in the list below; tests/contract/friction_contract.cpp says what it must keep.
namespace stridor::model {

using FrictionLaw = std::variant<Coulomb, Directional>;

/// Largest friction force over normal force [1], without sign, that keeps a stuck contact from slipping that way.
double stick_limit(const FrictionLaw& law, Slip way);

/// Friction force over normal force [1], T/N on the rubbed mass, while the contact slips that way: against the slip, so
/// at most 0 forward and at least 0 backward, and within the limit of the stick that way.
double slip_ratio(const FrictionLaw& law, Slip way);

/// Can a contact stick with these forces [N]? Never if N < 0.
bool holds(const FrictionLaw& law, double normal_force, double friction_force);

/// The law of a case.
FrictionLaw friction_law(const parameters::Contact& contact);

}  // namespace stridor::model
