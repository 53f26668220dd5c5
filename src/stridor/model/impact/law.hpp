#pragma once

#include "stridor/model/impact/normal_only.hpp"
#include "stridor/model/impact/plastic.hpp"
#include "stridor/model/impact/restitution.hpp"
#include "stridor/parameters/case.hpp"

#include <variant>

/// What happens when a separation ends. A law is a struct of its numbers and one function; the engines call it and know
/// no law. A new one is a file pair beside `plastic` and its name in the list below; tests/contract/impact_contract.cpp
/// says what it must keep.
namespace stridor::model {

using ImpactLaw = std::variant<Plastic, NormalOnly, Restitution>;

/// The impulses of one impact. Kinetic energy never grows by them, nor by what the moving surface does not give.
Impulses impulses(const ImpactLaw& law, const ContactInertia& inertia, const FrictionLaw& friction,
                  const Approach& approach);

/// The law of a case.
ImpactLaw impact_law(const parameters::Contact& contact);

}  // namespace stridor::model
