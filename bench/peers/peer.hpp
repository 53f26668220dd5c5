#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"

#include <functional>
#include <string>
#include <vector>

namespace stridor::peers {

/// A program with its settings: a case in, the life of its contact out. What it throws is reported as its failure.
struct Peer {
    std::string name;
    std::function<record::ContactHistory(const parameters::Case&)> run;
};

/// Everybody that is compared, in the order of the tables; a peer that was not found when configuring is left out.
std::vector<Peer> peers();

/// Who is compared besides where the equations are stiff.
std::vector<Peer> stiff_peers();

/// What was compared, and what was not found: one line each.
std::vector<std::string> peer_versions();

}  // namespace stridor::peers
