#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "baker/journal.hpp"
#include "engine/core/error.hpp"
#include "engine/core/log.hpp"
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace afterglow
{
namespace
{
constexpr std::string_view kKind = "afterglow journal ";
constexpr std::string_view kMagic = "afterglow journal 3\n"; // then the key, then records
constexpr std::size_t kKeySize = 64;                         // of bakeKey()
constexpr std::uint32_t kLargestRecord = 1u << 30;

// Numbers as the machine has them: a journal does not travel. One of another byte order fails its checksums.
struct Record {
    std::uint64_t checksum; // of what follows, bytes included
    std::uint64_t layer;
    Job job;
    std::uint32_t index, step;
    std::uint32_t size; // of the bytes
    RayCount rays;
    Spent spent; // by the whole bake until then
    Unit unit() const { return {job, index, step, layer}; }
};
static_assert(sizeof(Record) == 96, "no padding: all of it is written");

// As FNV-1a, eight bytes at a time: each step is a bijection, so that no change within one word goes unseen.
std::uint64_t checksumOf(std::span<const std::uint8_t> bytes)
{
    std::uint64_t sum = 0xcbf29ce484222325u ^ bytes.size();
    while (!bytes.empty()) {
        std::uint64_t word = 0;
        const std::size_t size = std::min(bytes.size(), sizeof word);
        std::memcpy(&word, bytes.data(), size);
        sum = (sum ^ word) * 0x100000001b3u;
        bytes = bytes.subspan(size);
    }
    return sum;
}

std::uint64_t checksumOfRecord(const std::vector<std::uint8_t>& record)
{
    return checksumOf(std::span(record).subspan(sizeof Record::checksum));
}

std::string reason() { return std::error_code(errno, std::generic_category()).message(); }

Spent clocks()
{
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return {std::chrono::duration<double>(now).count(), double(std::clock()) / CLOCKS_PER_SEC};
}

bool readAt(int file, void* to, std::size_t size, std::uint64_t at)
{
    auto* bytes = static_cast<std::uint8_t*>(to);
    while (size > 0) {
        const ssize_t got = pread(file, bytes, size, off_t(at));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes += got, size -= std::size_t(got), at += std::uint64_t(got);
    }
    return true;
}

bool beginsWith(int file, std::string_view text)
{
    std::string found(text.size(), '\0');
    return readAt(file, found.data(), found.size(), 0) && found == text;
}

bool writeAt(int file, std::span<const std::uint8_t> bytes, std::uint64_t at)
{
    while (!bytes.empty()) {
        const ssize_t put = pwrite(file, bytes.data(), bytes.size(), off_t(at));
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) return false;
        bytes = bytes.subspan(std::size_t(put));
        at += std::uint64_t(put);
    }
    return true;
}

// Whether the file that is open still has its name: whoever held it before may have removed it.
bool stands(int file, const std::filesystem::path& path)
{
    struct stat open {
    }, named{};
    return fstat(file, &open) == 0 && stat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}
}

Journal::Journal(const std::filesystem::path& place, const std::string& key, Start start)
    : path_(place.string() + ".journal"), key_(key), began_(clocks())
{
    open(path_);
    try {
        read(key, start);
    } catch (...) {
        close(file_);
        throw;
    }
}

Journal::Journal(const std::filesystem::path& kept) : path_(kept), key_(kKeySize, ' ')
{
    file_ = ::open(kept.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file_ < 0) throw Error("cannot read " + kept.string() + ": " + reason());
    try {
        const std::uint64_t size = sizeOfOwn();
        if (size > kMagic.size() + key_.size() && beginsWith(file_, kMagic)) index(size);
    } catch (...) {
        close(file_);
        throw;
    }
}

Journal::~Journal()
{
    struct stat now {
    };
    if (fstat(file_, &now) == 0 && now.st_size == 0) unlink(path_.c_str());
    close(file_);
}

void Journal::open(const std::filesystem::path& path)
{
    std::error_code problem;
    std::filesystem::create_directories(path.parent_path(), problem);
    for (;;) {
        file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
        if (file_ < 0) throw Error("cannot write " + path.string() + ": " + reason() + "; choose another place");
        const bool taken = flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK; // a file system may know no locks
        if (!taken && stands(file_, path)) return;
        close(file_);
        if (taken)
            throw Error("another bake is writing " + path.stem().string() + " (it holds " + path.string() +
                        "); wait for it, or name another folder");
    }
}

// Bytes of the file, which is a journal or the beginning of one, if of another program. Throws Error when it is not.
std::uint64_t Journal::sizeOfOwn() const
{
    struct stat now {
    };
    if (fstat(file_, &now) != 0 || !S_ISREG(now.st_mode)) throw Error(path_.string() + " is not a file; move it away");
    const auto size = std::uint64_t(now.st_size);
    std::string found(std::min(std::size_t(size), kKind.size()), '\0');
    if (!readAt(file_, found.data(), found.size(), 0)) throw Error("cannot read " + path_.string() + ": " + reason());
    if (!kKind.starts_with(found))
        throw Error(path_.string() + " is not the journal of a bake, which would take its place; move it away, or name another folder");
    return size;
}

void Journal::read(const std::string& key, Start start)
{
    const std::uint64_t size = sizeOfOwn();
    const std::string header = std::string(kMagic) + key;
    const std::uint64_t whole = beginsWith(file_, header) ? index(size) : 0;
    const std::string place = path_.stem().string();
    if (units_.empty()) {
        if (start == Start::resume)
            note(size <= header.size()
                     ? "there is no unfinished bake of " + place + " to resume: it starts from the beginning"
                     : "the unfinished bake of " + place +
                           " is of other options, another level or another program, or damaged: it starts from the beginning");
        return;
    }
    const Spent kept = before_;
    if (start == Start::resume && ftruncate(file_, off_t(whole)) == 0) {
        note(fmt::format("resuming the bake of {}, of which {:.1f} s of work are done", place, kept.seconds));
        whole_ = whole;
        return;
    }
    note(fmt::format("an unfinished bake of {} lies there, {:.1f} s of work: --resume goes on with it; this one starts afresh", place,
                     kept.seconds));
    units_.clear(), spentBy_.clear();
    before_ = {};
}

// Notes where the records are, as far as they are whole; returns where they end.
std::uint64_t Journal::index(std::uint64_t size)
{
    std::uint64_t at = kMagic.size() + key_.size();
    std::vector<std::uint8_t> bytes;
    while (size - at >= sizeof(Record)) {
        Record record;
        if (!readAt(file_, &record, sizeof record, at) || record.size > kLargestRecord || record.size > size - at - sizeof record) break;
        bytes.resize(sizeof record + record.size);
        if (!readAt(file_, bytes.data(), bytes.size(), at) || checksumOfRecord(bytes) != record.checksum) break;
        units_[record.unit()] = {at + sizeof record, record.size, record.rays};
        Spent& by = spentBy_[record.job]; // the time since the record before
        by.seconds += record.spent.seconds - before_.seconds;
        by.cpuSeconds += record.spent.cpuSeconds - before_.cpuSeconds;
        before_ = record.spent;
        at += bytes.size();
    }
    return at;
}

std::optional<Done> Journal::recall(const Unit& unit) const
{
    Place place;
    {
        std::lock_guard lock(changing_);
        const auto found = units_.find(unit);
        if (found == units_.end()) return std::nullopt;
        place = found->second;
    }
    Done done{std::vector<std::uint8_t>(place.size), place.rays};
    if (!readAt(file_, done.bytes.data(), done.bytes.size(), place.at)) return std::nullopt;
    return done;
}

void Journal::keep(const Unit& unit, std::span<const std::uint8_t> bytes, const RayCount& rays)
{
    if (bytes.size() > kLargestRecord) return;
    Record record{0, unit.layer, unit.job, unit.index, unit.step, std::uint32_t(bytes.size()), rays, spent()};
    std::vector<std::uint8_t> whole(sizeof record + bytes.size());
    if (!bytes.empty()) std::memcpy(whole.data() + sizeof record, bytes.data(), bytes.size());
    std::memcpy(whole.data(), &record, sizeof record);
    record.checksum = checksumOfRecord(whole);
    std::memcpy(whole.data(), &record.checksum, sizeof record.checksum);
    std::lock_guard lock(changing_);
    if (append(whole)) units_[unit] = {whole_ - bytes.size(), record.size, rays};
}

void Journal::forget(const Unit& unit)
{
    std::lock_guard lock(changing_);
    units_.erase(unit);
}

bool Journal::append(const std::vector<std::uint8_t>& bytes)
{
    if (full_) return false;
    if (whole_ == 0) {
        const std::string header = std::string(kMagic) + key_;
        full_ = ftruncate(file_, 0) != 0 || !writeAt(file_, {reinterpret_cast<const std::uint8_t*>(header.data()), header.size()}, 0);
        whole_ = header.size();
    }
    full_ = full_ || !writeAt(file_, bytes, whole_);
    if (full_)
        warning("cannot write " + path_.string() + ": " + reason() +
                "; the bake goes on, and what it does from here on could not be resumed");
    else
        whole_ += bytes.size();
    return !full_;
}

void Journal::finish(const std::filesystem::path& kept)
{
    if (kept.empty() ? unlink(path_.c_str()) != 0 : rename(path_.c_str(), kept.c_str()) != 0)
        warning("cannot " + (kept.empty() ? "remove " + path_.string() : "make " + kept.string() + " of " + path_.string()) + ": " +
                reason());
    whole_ = 0;
}

Spent Journal::before(Job job) const
{
    const auto found = spentBy_.find(job);
    return found == spentBy_.end() ? Spent{} : found->second;
}

Spent Journal::spent() const
{
    const Spent now = clocks();
    return {before_.seconds + now.seconds - began_.seconds, before_.cpuSeconds + now.cpuSeconds - began_.cpuSeconds};
}
}
