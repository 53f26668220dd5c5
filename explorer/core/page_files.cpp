// Files in a page that has none: whoever asks for one is told so.

#include "stridor/base/error.hpp"
#include "stridor/io/structure/part_files.hpp"
#include "stridor/io/structure/reduced_netcdf.hpp"
#include "stridor/recordings/audio/audio.hpp"
#include "stridor/recordings/audio/compressed_audio.hpp"
#include "stridor/recordings/bytes.hpp"
#include "stridor/recordings/recording_files.hpp"
#include "stridor/storage/atomic_file.hpp"

namespace stridor {

namespace {

Error not_here(const std::string& path) {
    return {ErrorKind::input,
            {"\"" + path + "\" is not opened", "the page in one file opens no other file",
             "Open this case with stridor explore."}};
}

}  // namespace

namespace storage {

// weak: a test lends files
[[gnu::weak]] std::string read_file(const std::string& path) {
    throw not_here(path);
}

void write_file(const std::string& path, std::string_view) {
    throw not_here(path);
}

}  // namespace storage

namespace recordings {

std::shared_ptr<const Bytes> open_bytes(const std::string& path) {
    throw not_here(path);
}

std::shared_ptr<const Bytes> open_plain_bytes(const std::string& path) {
    throw not_here(path);
}

// recordings are files
bool is_audio(std::string_view) {
    return false;
}

bool is_compressed_audio(std::string_view) {
    return false;
}

bool has_recording_name(std::string_view) {
    return false;
}

std::string text_at(const Bytes& bytes, std::uint64_t offset, std::size_t length) {
    std::string text(length, '\0');
    text.resize(bytes.read_at(offset, text));
    return text;
}

}  // namespace recordings

namespace io {

reduction::ElasticPart read_part(const PartFiles& files) {
    throw not_here(origin(files));
}

std::string origin(const PartFiles& files) {
    return files.files.empty() ? files.stiffness : files.files.front();
}

bool is_netcdf(std::string_view) {
    return false;
}

reduction::Reduction read_reduced_part(const std::string& path) {
    throw not_here(path);
}

}  // namespace io

}  // namespace stridor
