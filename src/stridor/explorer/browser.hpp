#pragma once

#include <string>

namespace stridor::explorer {

/// Is there a screen that a browser could show something on?
bool has_screen();

/// Opens a file in the user's browser, without waiting for it; what the opener says is of no interest.
void open_browser(const std::string& file);

}  // namespace stridor::explorer
