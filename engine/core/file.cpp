#include "engine/core/file.hpp"
#include "engine/core/error.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/scaffold.hpp"
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <map>
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
    if (!file && errno == ENOENT) throw Error("cannot read " + path.string() + ": there is no such file; check the name");
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

// A device or a pipe takes bytes, and no other file its place.
static bool isStream(const std::filesystem::path& path)
{
    std::error_code none;
    return std::filesystem::is_other(std::filesystem::status(path, none));
}

static void writeAll(const std::filesystem::path& at, const std::filesystem::path& path, const void* data, std::size_t size)
{
    Handle file(std::fopen(at.c_str(), "wb"), std::fclose);
    if (!file) throw Error("cannot write " + path.string() + ": " + reason());
    const bool written = size == 0 || std::fwrite(data, 1, size, file.get()) == size;
    const bool closed = std::fclose(file.release()) == 0;
    if (!written || !closed) throw Error("cannot write " + path.string() + ": " + reason());
}

void writeFile(const std::filesystem::path& path, const void* data, std::size_t size)
{
    if (isStream(path)) return writeAll(path, path, data, size);
    Scaffold beside(path, Scaffold::Kind::file);
    writeAll(beside.path(), path, data, size);
    beside.takePlace();
}

void writeText(const std::filesystem::path& path, std::string_view text) { writeFile(path, text.data(), text.size()); }

static void tryScaffold(const std::filesystem::path& path)
{
    // The nearest folder that is there: those below it are made when there is something to write
    std::filesystem::path place = placeOf(path), folder = place.parent_path();
    while (!std::filesystem::exists(folder) && folder.has_relative_path()) {
        place = folder;
        folder = folder.parent_path();
    }
    {
        const Scaffold tried(place, Scaffold::Kind::file);
    }
    stopIfInterrupted(); // what came while it stood
}

void requireWritable(const std::filesystem::path& path)
{
    if (std::filesystem::is_directory(placeOf(path)) || !path.has_filename())
        throw Error("cannot write " + path.string() + ": it is a folder; name a file");
    if (!isStream(path)) tryScaffold(path);
}

void requireWritableFolder(const std::filesystem::path& path) { tryScaffold(path); }

void requireApart(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs)
{
    std::map<std::filesystem::path, std::string> taken; // by which word
    for (const NamedFile& input : inputs) {
        std::error_code absent; // then there is nothing to lose
        const std::filesystem::path place = std::filesystem::canonical(input.path, absent);
        if (!absent) taken.emplace(place, input.word);
    }
    for (const NamedFile& output : outputs) {
        if (output.path.empty() || isStream(output.path)) continue;
        const auto [other, isNew] = taken.emplace(placeOf(output.path), output.word);
        if (!isNew)
            throw Error(other->second + " and " + output.word + " name the same file " + output.path.string() + "; name another",
                        Exit::usage);
    }
}

std::string suffix(const std::filesystem::path& path)
{
    std::string text = path.extension().string();
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

void requireEnding(const std::filesystem::path& output, const std::vector<std::string>& endings)
{
    if (output.empty()) throw Error("an output has an empty name; name a file", Exit::usage);
    if (std::find(endings.begin(), endings.end(), suffix(output)) != endings.end()) return;
    std::string known;
    for (const std::string& ending : endings) known += (known.empty() ? "" : " or ") + ending;
    throw Error("the output " + output.string() + " must end in " + known, Exit::usage);
}
}
