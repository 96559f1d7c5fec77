#include "engine/core/file.hpp"
#include "engine/core/error.hpp"
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
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
    const std::filesystem::path beside = path.string() + ".tmp";
    Handle file(std::fopen(beside.c_str(), "wb"), std::fclose);
    if (!file) throw Error("cannot write " + path.string() + ": " + reason());
    const bool written = size == 0 || std::fwrite(data, 1, size, file.get()) == size;
    const bool closed = std::fclose(file.release()) == 0;
    if (!written || !closed) {
        const std::string why = reason();
        std::remove(beside.c_str());
        throw Error("cannot write " + path.string() + ": " + why);
    }
    moveIntoPlace(beside, path);
}

void writeText(const std::filesystem::path& path, std::string_view text) { writeFile(path, text.data(), text.size()); }

void moveIntoPlace(const std::filesystem::path& from, const std::filesystem::path& to)
{
    std::error_code failed;
    std::filesystem::rename(from, to, failed);
    if (!failed) return;
    std::error_code ignored;
    std::filesystem::remove(from, ignored);
    throw Error("cannot write " + to.string() + ": " + failed.message());
}

void exchangeFolders(const std::filesystem::path& from, const std::filesystem::path& to)
{
    const auto demand = [&](bool done) {
        if (!done) throw Error("cannot write " + to.string() + ": " + reason());
    };
    if (!std::filesystem::exists(to)) return demand(std::rename(from.c_str(), to.c_str()) == 0);
    if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_EXCHANGE) == 0) return;

    // A file system that cannot exchange: the old folder steps aside first.
    const std::string aside = to.string() + ".old";
    demand(std::rename(to.c_str(), aside.c_str()) == 0);
    if (std::rename(from.c_str(), to.c_str()) != 0) {
        const std::string why = reason();
        std::rename(aside.c_str(), to.c_str());
        throw Error("cannot write " + to.string() + ": " + why);
    }
    demand(std::rename(aside.c_str(), from.c_str()) == 0);
}

void requireWritable(const std::filesystem::path& path)
{
    std::filesystem::path folder = std::filesystem::absolute(path).lexically_normal().parent_path(), probe = path;
    probe += ".tmp";
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);
    if (problem) throw Error("cannot write " + path.string() + ": " + problem.message() + "; choose another place");
    bool opened = Handle(std::fopen(probe.c_str(), "wb"), std::fclose) != nullptr;
    if (!opened) throw Error("cannot write " + path.string() + ": " + reason() + "; choose another place");
    std::filesystem::remove(probe, problem);
}
}
