#pragma once

#include "stridor/base/hash.hpp"
#include "stridor/noise_library/add_recordings.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/library.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// What the tests of the noise library share.
namespace stridor::noise_library {

inline void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

inline std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// A probe for files that are no sound: their length is their duration.
inline void probe_bytes(const std::filesystem::path& file, Entry& entry) {
    entry.duration = static_cast<double>(std::filesystem::file_size(file));
    entry.rate = 1.0;
    entry.channels = 1.0;
}

/// Adds bytes as a recording of some name.
inline Entry add_bytes(Library& library, const std::filesystem::path& file, const std::string& bytes,
                       Entry given = {}) {
    write_bytes(file, bytes);
    return add_recording(library, {file, std::move(given), Twins::refuse_same_audio}, probe_bytes);
}

/// Names of the audio files of a library, whatever folder they lie in, `incoming` too.
inline std::set<std::string> files_of(const Library& library) {
    std::set<std::string> names;
    if (!std::filesystem::exists(library.audio_folder())) return names;
    for (const auto& each : std::filesystem::recursive_directory_iterator(library.audio_folder()))
        if (each.is_regular_file()) names.insert(each.path().filename().string());
    return names;
}

/// What is wrong with a library that was just opened: entries whose audio is missing or other bytes, files that no
/// entry has; empty if nothing is.
inline std::string broken_promise(Library& library, bool (*has_audio)(const Library&, const Entry&)) {
    std::set<std::string> expected;
    Query everything;
    everything.extent = EntryExtent::whole;
    for (const Entry& entry : library.find(everything)) {
        if (!has_audio(library, entry)) return "entry " + std::to_string(entry.id) + " has not its audio";
        expected.insert(entry.audio + "." + entry.format);
    }
    for (const std::string& name : files_of(library))
        if (!expected.contains(name)) return name + " is an orphan";
    return {};
}

/// Are the bytes beside the library those that the entry names?
inline bool has_its_bytes(const Library& library, const Entry& entry) {
    return base::sha256_text(bytes_of(library.audio_file(entry))) == entry.audio;
}

inline Query whole(Query query = {}) {
    query.extent = EntryExtent::whole;
    return query;
}

/// An entry with every field set to something.
inline Entry full_entry() {
    Entry entry;
    double number = 0.5;
    for (const EntryField& field : fields())
        if (field.writer == Writer::stridor)
            continue;
        else if (std::holds_alternative<EntryQuantity>(field.kind))
            quantity_in(entry, field) = number += 1.25;
        else
            words_in(entry, field) = "words of " + std::string(field.name);
    entry.recorded = "rig";
    entry.date = "2026-11-21";
    set_figure(entry, {"level", "dB", 62.5});
    set_figure(entry, {"kurtosis", "1", 0.1});
    return entry;
}

/// A library in a folder of its own, and a sound to add.
class LibraryFile : public testing::Test {
protected:
    Library open(Access access = Access::fill) const { return Library(file_, {access, std::chrono::milliseconds(50)}); }

    support::ScratchFolder folder_;
    std::filesystem::path file_ = folder_ / "library.sqlite";
    std::filesystem::path sound_ = folder_ / "sound.wav";
};

}  // namespace stridor::noise_library
