#include "stridor/noise_library/check.hpp"

#include "stridor/base/error.hpp"
#include "stridor/noise_library/entry_rows.hpp"
#include "stridor/noise_library/library.hpp"
#include "stridor/noise_library/replacement.hpp"
#include "stridor/noise_library/salvage.hpp"

#include <algorithm>
#include <map>
#include <system_error>
#include <utility>

namespace stridor::noise_library {

namespace fs = std::filesystem;

namespace {

AudioName name_of_audio(const Entry& entry) {
    return {entry.audio, entry.format};
}

// "library.sqlite.damaged", or with a number where there is one already
fs::path name_for_damaged(const fs::path& file) {
    std::error_code ignored;
    fs::path name = file.string() + ".damaged";
    for (int number = 2; fs::exists(name, ignored); ++number)
        name = file.string() + ".damaged-" + std::to_string(number);
    return name;
}

}  // namespace

bool is_sound(const Findings& findings) {
    const Saved& saved = findings.saved;
    return saved.damages.empty() && saved.lost.empty() && findings.damaged_sounds.empty();
}

Findings check(const fs::path& file, const LibraryOptions& options) {
    Findings findings;
    findings.saved = saved_from(file, options);
    std::map<AudioName, std::vector<std::int64_t>> users;
    for (const Entry& entry : findings.saved.entries)
        users[name_of_audio(entry)].push_back(entry.id);
    findings.sounds = users.size();
    const fs::path folder = audio_folder_of(file);
    for (const auto& [name, ids] : users) {
        std::error_code error;
        const fs::path sound = folder / path_of(name);
        const bool is_there = fs::is_regular_file(sound, error);
        if (!is_there || !is_whole(sound, name)) findings.damaged_sounds.push_back({name, ids, !is_there});
    }
    return findings;
}

std::vector<AudioName> sounds_without_entry(const fs::path& audio_folder, std::span<const Entry> entries) {
    std::set<AudioName> known;
    for (const Entry& entry : entries)
        known.insert(name_of_audio(entry));
    std::set<AudioName> found;
    std::error_code error;
    for (fs::recursive_directory_iterator each(audio_folder, error), end; !error && each != end;
         each.increment(error)) {
        const AudioName name{each->path().stem().string(), format_of(each->path())};
        const bool is_candidate =
            is_audio_name(name) && !known.contains(name) && audio_folder / path_of(name) == each->path();
        if (is_candidate && is_whole(each->path(), name)) found.insert(name);
    }
    return {found.begin(), found.end()};
}

fs::path replace_database(const fs::path& file, std::span<const Entry> entries, std::int64_t last_id) {
    Replacement replacement(file);
    for (const Entry& entry : entries)
        if (entry.id != 0) replacement.write(entry);
    replacement.reserve(last_id);
    for (const Entry& entry : entries)
        if (entry.id == 0) replacement.write(entry);
    std::error_code error;
    const fs::path real = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
    fs::path kept = name_for_damaged(real);
    // a second name for the old file: the library's own never lacks one
    fs::create_hard_link(real, kept, error);
    if (error) fs::copy_file(real, kept, error);
    if (error) throw storage::system_failure("write", kept.string(), error.value());
    replacement.keep();
    fs::remove(real.string() + "-journal", error);
    return kept;
}

}  // namespace stridor::noise_library
