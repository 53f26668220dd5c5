#include "stridor/recordings/recording_files.hpp"

#include "stridor/recordings/sidecar.hpp"

#include <algorithm>
#include <array>
#include <system_error>

namespace stridor::recordings {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 16> sound_endings{".wav",  ".flac", ".ogg", ".aif", ".aiff", ".w64",
                                                         ".rf64", ".caf",  ".au",  ".mp3", ".opus", ".m4a",
                                                         ".aac",  ".3gp",  ".amr", ".webm"};
// not ".txt": most texts are no tables
constexpr std::array<std::string_view, 7> table_endings{".csv", ".tsv", ".uff", ".unv", ".uf", ".uff58", ".mat"};

bool ends_with_one_of(std::string_view name, std::span<const std::string_view> endings) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    const auto is_end = [&](std::string_view ending) {
        return name.size() > ending.size() &&
               std::equal(ending.rbegin(), ending.rend(), name.rbegin(), [&](char a, char b) { return a == lower(b); });
    };
    return std::any_of(endings.begin(), endings.end(), is_end);
}

bool is_sidecar(const fs::path& file) {
    if (file.extension() != ".json") return false;
    const fs::path recording = fs::path(file).replace_extension();
    std::error_code error;
    return sidecar_path(recording.string()) == file.string() && fs::is_regular_file(recording, error);
}

/// Walks down a folder, its entries by name.
class Walk {
public:
    Walk(RecordingFiles& found, const fs::path& left_out) : found_(found), left_out_(left_out) {}

    void enter(const fs::path& folder) {
        std::error_code error;
        if (fs::equivalent(folder, left_out_, error)) return;
        fs::directory_iterator each(folder, error);
        std::vector<fs::directory_entry> entries;
        while (!error && each != fs::directory_iterator()) {
            entries.push_back(*each);
            each.increment(error);
        }
        if (error) found_.unreadable.push_back({folder.string(), "cannot read the folder (" + error.message() + ")"});
        std::sort(entries.begin(), entries.end());
        for (const fs::directory_entry& entry : entries)
            take(entry);
    }

private:
    void take(const fs::directory_entry& entry) {
        std::error_code error;
        if (entry.path().filename().native().starts_with('.')) return;
        if (entry.is_directory(error)) {
            if (!entry.is_symlink(error)) enter(entry.path());
        } else if (entry.is_regular_file(error) && has_recording_name(entry.path().native())) {
            found_.files.push_back(entry.path());
        } else if (!is_sidecar(entry.path())) {
            ++found_.passed_over;
        }
    }

    RecordingFiles& found_;
    const fs::path& left_out_;
};

}  // namespace

bool has_sound_name(std::string_view name) {
    return ends_with_one_of(name, sound_endings);
}

bool has_recording_name(std::string_view name) {
    return has_sound_name(name) || ends_with_one_of(name, table_endings);
}

std::string refusal_reason(const std::string& file, const base::Error& error) {
    const base::Problem& problem = error.problem();
    const std::string place = error.place() ? base::describe(*error.place()) : file;
    const std::string why = problem.why.empty() ? "" : " (" + problem.why + ")";
    return (problem.what.find(file) == std::string::npos ? place + ": " : "") + problem.what + why;
}

RecordingFiles recording_files(std::span<const std::string> named, const fs::path& left_out) {
    RecordingFiles found;
    for (const std::string& name : named) {
        std::error_code error;
        if (fs::is_directory(name, error))
            Walk(found, left_out).enter(name);
        else if (!is_sidecar(name))
            found.files.emplace_back(name);
    }
    return found;
}

}  // namespace stridor::recordings
