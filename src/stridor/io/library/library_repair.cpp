#include "stridor/io/library/library_repair.hpp"

#include "stridor/base/error.hpp"
#include "stridor/io/library/library_archive.hpp"
#include "stridor/noise_library/field.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace stridor::io {

namespace fs = std::filesystem;
using noise_library::AudioName;
using noise_library::Entry;
using noise_library::Findings;
using noise_library::Library;
using noise_library::Staged;

namespace {

/// The entries of the library to be, and what became of those that were lost.
class Recovery {
public:
    Recovery(const noise_library::Saved& saved, Repair& repair)
        : entries_(saved.entries),
          lost_(saved.lost),
          repair_(&repair) {
        repair_->kept = entries_.size();
        for (const Entry& entry : entries_)
            digests_.insert(noise_library::digest(entry));
    }

    // those whose digest an index still has come back under their ids
    void take_by_digest(std::span<const Entry> archived) {
        for (const Entry& entry : archived) {
            const std::string digest = noise_library::digest(entry);
            const auto found =
                std::find_if(lost_.begin(), lost_.end(), [&](const auto& each) { return each.digest == digest; });
            if (found == lost_.end()) continue;
            add(entry, found->id);
            ++repair_->from_archives;
            lost_.erase(found);
        }
    }

    void take_by_sound(std::span<const Entry> archived, const fs::path& folder) {
        const std::vector<AudioName> orphans = noise_library::sounds_without_entry(folder, entries_);
        for (const Entry& entry : archived) {
            const bool has_sound =
                std::find(orphans.begin(), orphans.end(), AudioName{entry.audio, entry.format}) != orphans.end();
            if (!has_sound || digests_.contains(noise_library::digest(entry))) continue;
            add(entry, 0);
            ++repair_->from_archives;
        }
    }

    void hear(const fs::path& folder, const noise_library::Probe& probe) {
        for (const AudioName& name : noise_library::sounds_without_entry(folder, entries_)) {
            const fs::path sound = folder / noise_library::path_of(name);
            Entry entry;
            entry.file = sound.filename().string();
            entry.notes = "made anew from its sound when the library was repaired";
            try {
                probe(sound, entry);
            } catch (const Error& error) {
                // the sound is all there is, whether or not it can be read as one
                if (error.kind() != ErrorKind::input) throw;
            }
            entry.audio = name.hash;
            entry.format = name.format;
            add(entry, 0);
            ++repair_->from_sounds;
        }
    }

    const std::vector<Entry>& entries() const { return entries_; }

    std::vector<std::int64_t> lost() const {
        std::vector<std::int64_t> ids;
        for (const noise_library::LostEntry& each : lost_)
            ids.push_back(each.id);
        return ids;
    }

private:
    void add(Entry entry, std::int64_t id) {
        entry.id = id;
        digests_.insert(noise_library::digest(entry));
        entries_.push_back(std::move(entry));
    }

    std::vector<Entry> entries_;
    std::vector<noise_library::LostEntry> lost_;
    std::set<std::string> digests_;
    Repair* repair_;
};

void mend_sounds(const fs::path& file, std::span<const fs::path> archives, Repair& repair) {
    std::vector<AudioName> wanted;
    for (const noise_library::DamagedSound& sound : noise_library::check(file).damaged_sounds)
        wanted.push_back(sound.name);
    if (wanted.empty()) return;
    Library library(file, {noise_library::Access::fill});
    for (const fs::path& archive : archives) {
        noise_library::Intake intake(library.audio_folder());
        std::vector<Staged> staged = archived_audio(archive, intake, wanted);
        library.mend(intake, staged);
        for (const Staged& sound : staged)
            std::erase(wanted, sound.name);
        repair.mended_sounds += staged.size();
    }
}

}  // namespace

Repair repair_library(const fs::path& file, std::span<const fs::path> archives, const noise_library::Probe& probe) {
    Repair repair;
    repair.findings = noise_library::check(file);
    repair.kept = repair.findings.saved.entries.size();
    if (is_sound(repair.findings)) return repair;
    std::vector<Entry> archived;
    for (const fs::path& archive : archives)
        for (Entry& entry : archived_entries(archive))
            archived.push_back(std::move(entry));

    const noise_library::Saved& saved = repair.findings.saved;
    if (!saved.damages.empty() || !saved.lost.empty()) {
        const fs::path folder = noise_library::audio_folder_of(file);
        Recovery recovery(saved, repair);
        recovery.take_by_digest(archived);
        recovery.take_by_sound(archived, folder);
        recovery.hear(folder, probe);
        repair.lost = recovery.lost();
        repair.damaged_file = noise_library::replace_database(file, recovery.entries(), saved.last_id);
    }
    mend_sounds(file, archives, repair);
    repair.findings = noise_library::check(file);
    return repair;
}

}  // namespace stridor::io
