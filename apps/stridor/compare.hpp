#pragma once

#include "stridor/classification/compared_sound.hpp"

#include <span>
#include <string>

namespace CLI {
class App;
}

namespace stridor::app {

/// A row per figure, a column per sound, and the distances of all from the first.
std::string comparison_table(std::span<const classification::ComparedSound> sounds);

/// "squeal (going), none (coming)"; "-" where it is not known.
std::string contact_words(const classification::KnownContact& contact);

/// `stridor figure compare`.
void add_figure_compare(CLI::App& figure);

}  // namespace stridor::app
