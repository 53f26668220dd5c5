// Files in a page: those that were chosen together with a case. Whoever asks for another is told so.

#include "page_files.hpp"

#include "stridor/base/error.hpp"
#include "stridor/io/structure/reduced_netcdf.hpp"
#include "stridor/io/structure/zip_archive.hpp"
#include "stridor/recordings/audio/audio.hpp"
#include "stridor/recordings/audio/compressed_audio.hpp"
#include "stridor/recordings/bytes.hpp"
#include "stridor/recordings/mat/mat.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/recording_files.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

namespace stridor {

namespace {

using Content = std::shared_ptr<const std::string>;

std::map<std::string, Content>& kept_files() {
    static std::map<std::string, Content> only;
    return only;
}

std::string last_part(const std::string& path) {
    return path.substr(path.find_last_of("/\\") + 1);
}

Content kept(const std::string& path) {
    const auto found = kept_files().find(last_part(path));
    if (found != kept_files().end()) return found->second;
    throw Error(ErrorKind::input, {"\"" + path + "\" is not here", "a page opens only what was chosen together",
                                   "Choose it together with the case, or use stridor explore."});
}

Error not_read(const std::string& path) {
    return {ErrorKind::input,
            {"\"" + path + "\" is not read by the page in one file", "only the program reads files of this kind",
             "Use stridor explore."}};
}

class KeptBytes final : public recordings::Bytes {
public:
    explicit KeptBytes(Content content) : content_(std::move(content)) {}

    std::uint64_t size() const override { return content_->size(); }

    std::size_t read_at(std::uint64_t offset, std::span<char> into) const override {
        return offset < content_->size() ? content_->copy(into.data(), into.size(), offset) : 0;
    }

private:
    Content content_;
};

}  // namespace

namespace storage {

void keep_file(const std::string& name, std::string bytes) {
    kept_files()[name] = std::make_shared<const std::string>(std::move(bytes));
}

void forget_files() {
    kept_files().clear();
}

// for <filesystem>, whose machine has no other files
bool is_kept(const std::string& path) {
    return kept_files().contains(last_part(path));
}

// weak: a test lends files
[[gnu::weak]] std::string read_file(const std::string& path) {
    return *kept(path);
}

void write_file(const std::string& path, std::string_view) {
    throw not_read(path);
}

}  // namespace storage

namespace recordings {

std::shared_ptr<const Bytes> open_bytes(const std::string& path) {
    return std::make_shared<KeptBytes>(kept(path));
}

std::shared_ptr<const Bytes> open_plain_bytes(const std::string& path) {
    return open_bytes(path);
}

std::shared_ptr<const Bytes> bytes_of(std::string content) {
    return std::make_shared<KeptBytes>(std::make_shared<const std::string>(std::move(content)));
}

// the browser decodes it
bool is_compressed_audio(std::string_view) {
    return false;
}

RawSignal open_compressed_audio(const SignalInput& input) {
    throw not_read(input.name);
}

bool has_recording_name(std::string_view) {
    return false;
}

bool has_sound_name(std::string_view) {
    return false;
}

bool is_mat(std::string_view beginning) {
    return beginning.starts_with("MATLAB");
}

RawSignal open_mat(const SignalInput& input, const mat::Wishes&) {
    throw not_read(input.name);
}

std::string text_at(const Bytes& bytes, std::uint64_t offset, std::size_t length) {
    const std::uint64_t left = bytes.size() - std::min(offset, bytes.size());
    std::string text(static_cast<std::size_t>(std::min<std::uint64_t>(length, left)), '\0');
    text.resize(bytes.read_at(offset, text));
    return text;
}

}  // namespace recordings

namespace io {

bool is_netcdf(std::string_view beginning) {
    return beginning.starts_with("\x89HDF\r\n\x1a\n") || beginning.starts_with("CDF");
}

reduction::Reduction read_reduced_part(const std::string& path) {
    throw not_read(path);
}

namespace structure {

bool is_zip(std::string_view beginning) {
    return beginning.starts_with("PK\x03\x04");
}

// the page has unpacked it: its files stand below its name
std::map<std::string, std::string> read_zip(const StructureInput& input) {
    const std::string below = last_part(input.name) + "/";
    std::map<std::string, std::string> members;
    for (auto each = kept_files().lower_bound(below); each != kept_files().end() && each->first.starts_with(below);
         ++each)
        members.try_emplace(each->first.substr(below.size()), *each->second);
    return members;
}

}  // namespace structure

}  // namespace io

}  // namespace stridor
