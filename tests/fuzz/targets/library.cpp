#include "stridor/noise_library/library.hpp"

#include "fuzz/targets/damaged_file.hpp"
#include "fuzz/targets/targets.hpp"
#include "stridor/base/error.hpp"
#include "stridor/noise_library/check.hpp"
#include "stridor/noise_library/entry_rows.hpp"
#include "stridor/noise_library/field.hpp"

#include <string>

namespace stridor::fuzz {

namespace {

using noise_library::Entry;

std::string told_by(const std::filesystem::path& file) {
    noise_library::Library library(file, {noise_library::Access::read, std::chrono::milliseconds(0)});
    noise_library::Query query;
    query.extent = noise_library::EntryExtent::whole;
    std::string text = std::to_string(library.count(query)) + " " + std::to_string(library.size());
    library.visit(query, [&](const Entry& entry) {
        text += "\n" + std::to_string(entry.id) + " " + noise_library::digest(entry);
        // a path is made of what the database says
        require(library.audio_file(entry).native().size() < 500);
    });
    for (const noise_library::FigureKind& figure : library.figures())
        text += figure.name + figure.unit;
    for (const std::string& word : library.words("system"))
        text += word;
    return text;
}

/// A sound library, and where its damaged copies are opened.
struct LibraryBench {
    support::ScratchFolder folder{};
    std::filesystem::path file = folder / "library.sqlite";
    std::string sound{};
    std::string told{};

    LibraryBench() {
        { noise_library::Library(file, {noise_library::Access::fill}); }
        storage::DatabaseOptions options;
        options.identity = noise_library::library_identity;
        {
            storage::Database database(file, options);
            for (int k = 0; k < 3; ++k) {
                Entry entry;
                entry.system = "system " + std::to_string(k);
                entry.audio = std::string(64, static_cast<char>('a' + k));
                entry.format = "wav";
                entry.preload = 10.0 * k;
                entry.case_text = std::string(50, 'c');
                noise_library::set_figure(entry, {"level", "dB", 1.0 / 3.0});
                noise_library::write_entry(database, entry);
            }
        }
        sound = file_bytes(file);
        told = told_by(file);
    }
};

}  // namespace

void library(std::string_view bytes) {
    static const LibraryBench bench;
    const Damage damage = damaged(bench.sound, bytes);
    put_database(bench.file, damage.bytes);
    // SQLite takes a file of one byte for an empty one, too
    const bool may_differ = damage.is_mended || damage.bytes.size() <= 1;
    const auto ends_well = [&](const auto& use) {
        try {
            use();
        } catch (const Error& error) {
            require(error.kind() == ErrorKind::input || error.kind() == ErrorKind::io);
        }
    };
    // what can be saved of it is what was written
    ends_well([&] {
        for (const Entry& entry : noise_library::check(bench.file, {}).saved.entries)
            require(may_differ || bench.told.find(noise_library::digest(entry)) != std::string::npos);
    });
    ends_well([&] { require(told_by(bench.file) == bench.told || may_differ); });
}

}  // namespace stridor::fuzz
