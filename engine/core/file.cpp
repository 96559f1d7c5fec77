#include "engine/core/file.hpp"
#include "engine/core/error.hpp"
#include "engine/core/scaffold.hpp"
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace afterglow
{
using Handle = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

static std::string reason() { return std::error_code(errno, std::generic_category()).message(); }

// A folder opens like a file on Linux and reads as nothing: say so before it surprises.
static Handle openForReading(const std::filesystem::path& path)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw Error("cannot read " + path.string() + ": it is a folder, name a file");
    Handle file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) throw Error("cannot read " + path.string() + ": " + reason());
    return file;
}

template <class Bytes>
static Bytes readAll(const std::filesystem::path& path)
{
    Handle file = openForReading(path);
    Bytes bytes;
    std::error_code unknown; // of a pipe, say: then it grows as it is read
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    if (!unknown) bytes.reserve(std::size_t(size));
    char block[1 << 16];
    while (const std::size_t got = std::fread(block, 1, sizeof block, file.get())) bytes.insert(bytes.end(), block, block + got);
    if (std::ferror(file.get())) throw Error("cannot read " + path.string() + ": " + reason());
    return bytes;
}

std::vector<std::uint8_t> readFile(const std::filesystem::path& path) { return readAll<std::vector<std::uint8_t>>(path); }

std::string readText(const std::filesystem::path& path) { return readAll<std::string>(path); }

void writeFile(const std::filesystem::path& path, const void* data, std::size_t size)
{
    Scaffold beside(path, Scaffold::Kind::file);
    Handle file(std::fopen(beside.path().c_str(), "wb"), std::fclose);
    if (!file) throw Error("cannot write " + path.string() + ": " + reason());
    const bool written = size == 0 || std::fwrite(data, 1, size, file.get()) == size;
    const bool closed = std::fclose(file.release()) == 0;
    if (!written || !closed) throw Error("cannot write " + path.string() + ": " + reason());
    beside.takePlace();
}

void writeText(const std::filesystem::path& path, std::string_view text) { writeFile(path, text.data(), text.size()); }

std::filesystem::path withoutSlash(const std::filesystem::path& folder)
{
    const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

void requireWritable(const std::filesystem::path& path)
{
    // The nearest folder that is there: those below it are made when there is something to write
    std::filesystem::path place = withoutSlash(path), folder = place.parent_path();
    while (!std::filesystem::exists(folder) && folder.has_relative_path()) {
        place = folder;
        folder = folder.parent_path();
    }
    const Scaffold tried(place, Scaffold::Kind::file);
}
}
