#pragma once

namespace CLI {
class App;
}

namespace stridor::app {

/// `stridor figure compare`.
void add_figure_compare(CLI::App& figure);

}  // namespace stridor::app
