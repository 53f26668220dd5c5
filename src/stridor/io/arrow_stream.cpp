#include "stridor/io/arrow_stream.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <utility>

// What is handed out points into one table that everybody shares: a chunk into its middle. Each schema and each array,
// a child or a dictionary too, has a holder of its own behind private_data, for consumers may move a child away from
// its parent and release it later.

namespace stridor::io {

namespace {

constexpr std::size_t bits = 8;

/// The buffers of a column as Arrow wants them.
struct Buffers {
    std::vector<std::uint8_t> validity;  // a bit per row; empty: all are there
    std::vector<std::int64_t> integers;
    std::vector<std::int32_t> indices;
    std::vector<std::int32_t> ends{0};  // of the words, in `letters`
    std::string letters;
};

struct SharedColumns {
    ArrowTable table;
    std::vector<Buffers> buffers;  // shape [column]
    std::size_t rows = 0;
};

using SharedTable = std::shared_ptr<const SharedColumns>;

// without its values where other buffers hold them
Buffers buffers_of(ArrowColumn& column) {
    Buffers made;
    for (std::size_t row = 0; row < column.values.size(); ++row) {
        const double value = column.values[row];
        const bool is_there = !std::isnan(value);
        if (!is_there && made.validity.empty()) made.validity.assign(column.values.size() / bits + 1, 0xff);
        if (!is_there) made.validity[row / bits] &= static_cast<std::uint8_t>(~(1U << row % bits));
        if (column.kind == ArrowKind::integer) made.integers.push_back(is_there ? static_cast<std::int64_t>(value) : 0);
        if (column.kind != ArrowKind::word) continue;
        if (is_there && !(value >= 0.0 && value < static_cast<double>(column.words.size())))
            base::refuse("column " + column.name + " has a word that is none", "", "");
        made.indices.push_back(is_there ? static_cast<std::int32_t>(value) : 0);
    }
    for (const std::string& word : column.words) {
        made.letters += word;
        if (made.letters.size() > std::numeric_limits<std::int32_t>::max())
            base::refuse("the words of column " + column.name + " exceed 2 GiB", "", "");
        made.ends.push_back(static_cast<std::int32_t>(made.letters.size()));
    }
    if (column.kind != ArrowKind::number) column.values = {};
    return made;
}

SharedTable shared(ArrowTable table) {
    STRIDOR_EXPECT(table.rows_at_once > 0 && table.rows_at_once % 64 == 0);
    auto made = std::make_shared<SharedColumns>();
    if (!table.columns.empty()) made->rows = table.columns.front().values.size();
    for (ArrowColumn& column : table.columns) {
        if (column.values.size() != made->rows)
            base::refuse("column " + column.name + " has another length than the first", "", "");
        made->buffers.push_back(buffers_of(column));
    }
    made->table = std::move(table);
    return made;
}

// pairs of keys and values as the specification packs them; nothing where there are none
std::string packed_metadata(const std::map<std::string, std::string>& pairs) {
    std::string text;
    const auto put = [&](std::size_t size) {
        const auto number = static_cast<std::int32_t>(size);
        text.append(reinterpret_cast<const char*>(&number), sizeof number);
    };
    if (pairs.empty()) return text;
    put(pairs.size());
    for (const auto& [key, value] : pairs) {
        put(key.size());
        text += key;
        put(value.size());
        text += value;
    }
    return text;
}

template <typename Record>
void release_record(Record* record);

/// Behind a schema or an array: what it points to, and its children that nobody has moved away.
template <typename Record>
struct Holder {
    Holder() = default;
    Holder(const Holder&) = delete;
    Holder& operator=(const Holder&) = delete;
    ~Holder() {
        for (const std::unique_ptr<Record>& child : children)
            release_record(child.get());
        release_record(dictionary.get());
    }

    SharedTable table{};
    std::string format{}, name{}, metadata{};  // of schemas
    std::vector<const void*> buffers{};        // of arrays
    std::vector<std::unique_ptr<Record>> children{};
    std::vector<Record*> pointers{};
    std::unique_ptr<Record> dictionary{};
};

template <typename Record>
void release_record(Record* record) {
    if (record == nullptr || record->release == nullptr) return;
    delete static_cast<Holder<Record>*>(record->private_data);
    record->release = nullptr;
    record->private_data = nullptr;
}

// hands a holder over to the record that points into it
template <typename Record>
void hold(Record& record, std::unique_ptr<Holder<Record>> holder) {
    for (const std::unique_ptr<Record>& child : holder->children)
        holder->pointers.push_back(child.get());
    record.n_children = static_cast<std::int64_t>(holder->children.size());
    record.children = holder->pointers.empty() ? nullptr : holder->pointers.data();
    record.dictionary = holder->dictionary.get();
    record.release = &release_record<Record>;
    record.private_data = holder.release();
}

ArrowSchema schema_of(const std::string& format, const std::string& name, const std::string& metadata,
                      std::unique_ptr<Holder<ArrowSchema>> holder, std::int64_t flags) {
    holder->format = format, holder->name = name, holder->metadata = metadata;
    ArrowSchema schema{};
    schema.format = holder->format.c_str();
    schema.name = holder->name.c_str();
    schema.metadata = holder->metadata.empty() ? nullptr : holder->metadata.data();
    schema.flags = flags;
    hold(schema, std::move(holder));
    return schema;
}

ArrowSchema column_schema(const ArrowColumn& column) {
    constexpr std::int64_t nullable = 2;
    auto holder = std::make_unique<Holder<ArrowSchema>>();
    const char* format = column.kind == ArrowKind::number ? "g" : column.kind == ArrowKind::integer ? "l" : "i";
    if (column.kind == ArrowKind::word) {
        holder->dictionary = std::make_unique<ArrowSchema>();
        *holder->dictionary = schema_of("u", "", "", std::make_unique<Holder<ArrowSchema>>(), 0);
    }
    return schema_of(format, column.name, packed_metadata(column.about), std::move(holder), nullable);
}

ArrowSchema table_schema(const SharedColumns& shared) {
    auto holder = std::make_unique<Holder<ArrowSchema>>();
    for (const ArrowColumn& column : shared.table.columns) {
        holder->children.push_back(std::make_unique<ArrowSchema>());
        *holder->children.back() = column_schema(column);
    }
    return schema_of("+s", "", packed_metadata(shared.table.about), std::move(holder), 0);
}

ArrowArray array_of(std::size_t length, std::int64_t nulls, std::vector<const void*> buffers,
                    std::unique_ptr<Holder<ArrowArray>> holder) {
    holder->buffers = std::move(buffers);
    ArrowArray array{};
    array.length = static_cast<std::int64_t>(length);
    array.null_count = nulls;
    array.n_buffers = static_cast<std::int64_t>(holder->buffers.size());
    array.buffers = holder->buffers.data();
    hold(array, std::move(holder));
    return array;
}

ArrowArray words_array(const SharedTable& table, std::size_t column) {
    const Buffers& buffers = table->buffers[column];
    auto holder = std::make_unique<Holder<ArrowArray>>();
    holder->table = table;
    return array_of(table->table.columns[column].words.size(), 0,
                    {nullptr, buffers.ends.data(), buffers.letters.data()}, std::move(holder));
}

ArrowArray column_array(const SharedTable& table, std::size_t column, std::size_t first, std::size_t count) {
    const ArrowColumn& of = table->table.columns[column];
    const Buffers& buffers = table->buffers[column];
    auto holder = std::make_unique<Holder<ArrowArray>>();
    holder->table = table;
    const void* validity = buffers.validity.empty() ? nullptr : buffers.validity.data() + first / bits;
    const void* values = of.kind == ArrowKind::number    ? static_cast<const void*>(of.values.data() + first)
                         : of.kind == ArrowKind::integer ? static_cast<const void*>(buffers.integers.data() + first)
                                                         : static_cast<const void*>(buffers.indices.data() + first);
    if (of.kind == ArrowKind::word) {
        holder->dictionary = std::make_unique<ArrowArray>();
        *holder->dictionary = words_array(table, column);
    }
    return array_of(count, validity == nullptr ? 0 : -1, {validity, values}, std::move(holder));
}

ArrowArray chunk_of(const SharedTable& table, std::size_t first, std::size_t count) {
    auto holder = std::make_unique<Holder<ArrowArray>>();
    for (std::size_t column = 0; column < table->table.columns.size(); ++column) {
        holder->children.push_back(std::make_unique<ArrowArray>());
        *holder->children.back() = column_array(table, column, first, count);
    }
    return array_of(count, 0, {nullptr}, std::move(holder));
}

/// Behind a stream.
struct Cursor {
    SharedTable table;
    std::size_t next = 0;  // row
    std::string error{};
};

// the answer to a consumer: an errno, and the words for it kept
template <typename Answer>
int answered(ArrowArrayStream* stream, Answer answer) {
    if (stream == nullptr || stream->release == nullptr) return EINVAL;
    Cursor& cursor = *static_cast<Cursor*>(stream->private_data);
    try {
        answer(cursor);
        return 0;
    } catch (const std::exception& error) {
        cursor.error = error.what();
        return ENOMEM;
    }
}

int get_schema(ArrowArrayStream* stream, ArrowSchema* out) {
    return answered(stream, [&](Cursor& cursor) { *out = table_schema(*cursor.table); });
}

int get_next(ArrowArrayStream* stream, ArrowArray* out) {
    return answered(stream, [&](Cursor& cursor) {
        const std::size_t left = cursor.table->rows - cursor.next;
        const std::size_t count = std::min(left, cursor.table->table.rows_at_once);
        // a released array is the end
        *out = count > 0 ? chunk_of(cursor.table, cursor.next, count) : ArrowArray{};
        cursor.next += count;
    });
}

const char* get_last_error(ArrowArrayStream* stream) {
    if (stream == nullptr || stream->release == nullptr) return nullptr;
    const Cursor& cursor = *static_cast<Cursor*>(stream->private_data);
    return cursor.error.empty() ? nullptr : cursor.error.c_str();
}

void release_stream(ArrowArrayStream* stream) {
    if (stream == nullptr || stream->release == nullptr) return;
    delete static_cast<Cursor*>(stream->private_data);
    stream->release = nullptr;
    stream->private_data = nullptr;
}

}  // namespace

ArrowArrayStream arrow_stream(ArrowTable table) {
    auto cursor = std::make_unique<Cursor>(Cursor{shared(std::move(table))});
    return {&get_schema, &get_next, &get_last_error, &release_stream, cursor.release()};
}

}  // namespace stridor::io
