#include "stridor/report/pdf.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/process.hpp"
#include "stridor/base/text.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/storage/temporary.hpp"

#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <vector>

namespace stridor::report {

namespace {

constexpr std::array<std::string_view, 6> browsers{
    "chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "microsoft-edge", "brave-browser"};
constexpr std::string_view converter = "wkhtmltopdf";

// it takes some seconds
constexpr std::chrono::seconds longest_printing{300};

// the first that is there; empty if none is
std::string found_printer() {
    for (const std::string_view browser : browsers)
        if (base::is_on_path(std::string(browser))) return std::string(browser);
    return base::is_on_path(std::string(converter)) ? std::string(converter) : std::string();
}

std::vector<std::string> command_for(const std::string& printer, const std::filesystem::path& folder) {
    const std::string page = (folder / "report.html").string();
    const std::string sheet = (folder / "report.pdf").string();
    if (printer == converter) return {printer, "--quiet", "--page-size", "A4", "--print-media-type", page, sheet};
    std::vector<std::string> command{printer,
                                     "--headless",
                                     "--disable-gpu",
                                     "--no-first-run",
                                     "--no-pdf-header-footer",
                                     "--user-data-dir=" + (folder / "profile").string(),
                                     "--print-to-pdf=" + sheet};
    // a browser has no sandbox for root; the page is ours and runs no script
    if (::geteuid() == 0) command.emplace_back("--no-sandbox");
    command.push_back("file://" + page);
    return command;
}

}  // namespace

void expect_printer() {
    if (!found_printer().empty()) return;
    throw Error(ErrorKind::io,
                {"no program is there to make a PDF", "a browser (chromium, google-chrome) or wkhtmltopdf prints it",
                 "Install one, on Debian with: apt install chromium. Or write FILE.html and print that."});
}

std::string printed_pdf(std::string_view html) {
    expect_printer();
    const std::string printer = found_printer();
    const storage::PrivateFolder folder;
    storage::write_file((folder.path() / "report.html").string(), html);
    const base::ProcessResult result = base::run_process(command_for(printer, folder.path()), longest_printing);
    const std::filesystem::path sheet = folder.path() / "report.pdf";
    if (result.exit_status != 0 || !std::filesystem::exists(sheet)) {
        const std::string message(base::trimmed(result.messages));
        throw Error(ErrorKind::io, {printer + " could not print the report", message.substr(message.rfind('\n') + 1),
                                    "Write FILE.html and print that."});
    }
    return storage::read_file(sheet.string());
}

}  // namespace stridor::report
