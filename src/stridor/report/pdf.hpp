#pragma once

#include <string>
#include <string_view>

namespace stridor::report {

/// An HTML page printed on A4, as the bytes of a PDF file, by a browser or wkhtmltopdf that is found on PATH.
///
/// Throws `Error` (io) where there is none, saying what to install, or where it fails.
std::string printed_pdf(std::string_view html);

/// Throws `Error` (io) where no program is there to print: before the work begins.
void expect_printer();

}  // namespace stridor::report
