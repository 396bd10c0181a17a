// SPDX-License-Identifier: Apache-2.0
// A disk below SQLite whose power can fail: as long as the object lives, what is written stays in memory
// until its file is synced, and only then reaches the real file. Without power nothing is written any more,
// and of what was not synced all is gone, or any part of it has arrived: real disks reorder and tear. The
// index of the log, which is no data, is passed on.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cstring>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <random>
#include <string>
#include <vector>

namespace noctule::test {

class UnsyncedDisk {
public:
    /// Becomes the file system of every database that is opened from now on.
    UnsyncedDisk() : real_(sqlite3_vfs_find(nullptr)), vfs_(*real_) {
        the_disk_ = this;
        vfs_.pNext = nullptr;
        vfs_.zName = "unsynced";
        vfs_.szOsFile = static_cast<int>(sizeof(File)) + real_->szOsFile;
        vfs_.xOpen = &UnsyncedDisk::open;
        vfs_.xDelete = &UnsyncedDisk::remove;
        vfs_.xAccess = &UnsyncedDisk::access;
        EXPECT_EQ(sqlite3_vfs_register(&vfs_, 1), SQLITE_OK);
    }
    UnsyncedDisk(const UnsyncedDisk&) = delete;
    UnsyncedDisk& operator=(const UnsyncedDisk&) = delete;
    /// Every database on it must be closed.
    ~UnsyncedDisk() {
        sqlite3_vfs_unregister(&vfs_);
        sqlite3_vfs_register(real_, 1);
        the_disk_ = nullptr;
    }

    /// `survivors`: decides which unsynced writes have arrived all the same, perhaps in part; null: none.
    void losePower(std::mt19937* survivors) {
        const std::lock_guard lock(mutex_);
        has_power_ = false;
        for (auto& [path, content] : contents_)
            for (Write& write : content->unsynced)
                if (content->real && survivors && (*survivors)() % 2 == 0) {
                    if ((*survivors)() % 4 == 0)
                        write.bytes.resize(write.bytes.size() / 2);
                    apply(write, *content);
                }
    }
    int64_t syncs() const {
        const std::lock_guard lock(mutex_);
        return syncs_;
    }

private:
    struct Write {
        sqlite3_int64 at = 0;
        std::string bytes;
        bool truncates = false;  ///< at `at`
    };
    struct Content {
        std::string now;  ///< as the programs see it
        std::vector<Write> unsynced;
        sqlite3_file* real = nullptr;
    };
    struct File {
        sqlite3_file base;
        Content* content;  ///< null: passed on whole (temporary files)
        sqlite3_file* real() { return reinterpret_cast<sqlite3_file*>(this + 1); }
    };

    static File& self(sqlite3_file* file) { return *reinterpret_cast<File*>(file); }
    static void apply(const Write& write, Content& content) {
        if (write.truncates)
            content.real->pMethods->xTruncate(content.real, write.at);
        else if (!write.bytes.empty())
            content.real->pMethods->xWrite(content.real, write.bytes.data(),
                                           static_cast<int>(write.bytes.size()), write.at);
    }

    static int open(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* out_flags) {
        UnsyncedDisk& disk = *the_disk_;
        const std::lock_guard lock(disk.mutex_);
        File& opened = *new (file) File{{nullptr}, nullptr};
        const int code = disk.real_->xOpen(disk.real_, name, opened.real(), flags, out_flags);
        if (code != SQLITE_OK)
            return code;
        opened.base.pMethods = &kMethods;
        if (!name)
            return SQLITE_OK;
        std::unique_ptr<Content>& content = disk.contents_[name];
        if (!content) {
            content = std::make_unique<Content>();
            sqlite3_int64 size = 0;
            opened.real()->pMethods->xFileSize(opened.real(), &size);
            content->now.resize(static_cast<size_t>(size));
            opened.real()->pMethods->xRead(opened.real(), content->now.data(), static_cast<int>(size), 0);
        }
        content->real = opened.real();
        opened.content = content.get();
        return SQLITE_OK;
    }
    static int remove(sqlite3_vfs*, const char* name, int sync_folder) {
        UnsyncedDisk& disk = *the_disk_;
        const std::lock_guard lock(disk.mutex_);
        if (!disk.has_power_)
            return SQLITE_IOERR_DELETE;
        disk.contents_.erase(name);
        return disk.real_->xDelete(disk.real_, name, sync_folder);
    }
    static int access(sqlite3_vfs*, const char* name, int flags, int* result) {
        UnsyncedDisk& disk = *the_disk_;
        const std::lock_guard lock(disk.mutex_);
        const auto content = disk.contents_.find(name);
        if (flags == SQLITE_ACCESS_EXISTS && content != disk.contents_.end()) {
            *result = content->second->now.empty() ? 0 : 1;
            return SQLITE_OK;
        }
        return disk.real_->xAccess(disk.real_, name, flags, result);
    }

    static int closeFile(sqlite3_file* file) {
        const std::lock_guard lock(the_disk_->mutex_);
        if (Content* content = self(file).content; content && content->real == self(file).real())
            content->real = nullptr;  // what was not synced now depends on luck alone, and has none
        return self(file).real()->pMethods->xClose(self(file).real());
    }
    static int read(sqlite3_file* file, void* into, int count, sqlite3_int64 at) {
        const std::lock_guard lock(the_disk_->mutex_);
        if (!self(file).content)
            return self(file).real()->pMethods->xRead(self(file).real(), into, count, at);
        const std::string& now = self(file).content->now;
        const auto size = static_cast<sqlite3_int64>(now.size());
        const auto there = static_cast<size_t>(std::clamp<sqlite3_int64>(size - at, 0, count));
        std::memset(into, 0, static_cast<size_t>(count));
        if (there > 0)
            std::memcpy(into, now.data() + at, there);
        return there == static_cast<size_t>(count) ? SQLITE_OK : SQLITE_IOERR_SHORT_READ;
    }
    static int write(sqlite3_file* file, const void* bytes, int count, sqlite3_int64 at) {
        const std::lock_guard lock(the_disk_->mutex_);
        Content* content = self(file).content;
        if (!the_disk_->has_power_)
            return SQLITE_IOERR_WRITE;
        if (!content)
            return self(file).real()->pMethods->xWrite(self(file).real(), bytes, count, at);
        std::string text(static_cast<const char*>(bytes), static_cast<size_t>(count));
        const auto end = static_cast<size_t>(at) + text.size();
        content->now.resize(std::max(content->now.size(), end));
        content->now.replace(static_cast<size_t>(at), text.size(), text);
        content->unsynced.push_back({at, std::move(text), false});
        return SQLITE_OK;
    }
    static int truncate(sqlite3_file* file, sqlite3_int64 size) {
        const std::lock_guard lock(the_disk_->mutex_);
        Content* content = self(file).content;
        if (!the_disk_->has_power_)
            return SQLITE_IOERR_TRUNCATE;
        if (!content)
            return self(file).real()->pMethods->xTruncate(self(file).real(), size);
        content->now.resize(static_cast<size_t>(size));
        content->unsynced.push_back({size, "", true});
        return SQLITE_OK;
    }
    static int sync(sqlite3_file* file, int flags) {
        const std::lock_guard lock(the_disk_->mutex_);
        Content* content = self(file).content;
        if (!the_disk_->has_power_)
            return SQLITE_IOERR_FSYNC;
        if (!content)
            return self(file).real()->pMethods->xSync(self(file).real(), flags);
        ++the_disk_->syncs_;
        for (const Write& write : std::exchange(content->unsynced, {}))
            apply(write, *content);
        return SQLITE_OK;
    }
    static int fileSize(sqlite3_file* file, sqlite3_int64* size) {
        const std::lock_guard lock(the_disk_->mutex_);
        if (!self(file).content)
            return self(file).real()->pMethods->xFileSize(self(file).real(), size);
        *size = static_cast<sqlite3_int64>(self(file).content->now.size());
        return SQLITE_OK;
    }
    static int control(sqlite3_file* file, int operation, void* argument) {
        // These would write past us.
        if (operation == SQLITE_FCNTL_SIZE_HINT || operation == SQLITE_FCNTL_CHUNK_SIZE)
            return SQLITE_OK;
        if (operation == SQLITE_FCNTL_MMAP_SIZE)
            return SQLITE_NOTFOUND;
        return self(file).real()->pMethods->xFileControl(self(file).real(), operation, argument);
    }

    // Passed on as they are.
    static int lock(sqlite3_file* f, int level) {
        return self(f).real()->pMethods->xLock(self(f).real(), level);
    }
    static int unlock(sqlite3_file* f, int level) {
        return self(f).real()->pMethods->xUnlock(self(f).real(), level);
    }
    static int checkLock(sqlite3_file* f, int* result) {
        return self(f).real()->pMethods->xCheckReservedLock(self(f).real(), result);
    }
    static int sectorSize(sqlite3_file* f) { return self(f).real()->pMethods->xSectorSize(self(f).real()); }
    static int characteristics(sqlite3_file* f) {
        return self(f).real()->pMethods->xDeviceCharacteristics(self(f).real());
    }
    static int shmMap(sqlite3_file* f, int page, int size, int extend, void volatile** memory) {
        return self(f).real()->pMethods->xShmMap(self(f).real(), page, size, extend, memory);
    }
    static int shmLock(sqlite3_file* f, int offset, int count, int flags) {
        return self(f).real()->pMethods->xShmLock(self(f).real(), offset, count, flags);
    }
    static void shmBarrier(sqlite3_file* f) { self(f).real()->pMethods->xShmBarrier(self(f).real()); }
    static int shmUnmap(sqlite3_file* f, int removes) {
        return self(f).real()->pMethods->xShmUnmap(self(f).real(), removes);
    }

    static constexpr sqlite3_io_methods kMethods = {
        2,        closeFile, read,    write,      truncate,        sync,   fileSize, lock,
        unlock,   checkLock, control, sectorSize, characteristics, shmMap, shmLock,  shmBarrier,
        shmUnmap, nullptr,   nullptr};

    static inline UnsyncedDisk* the_disk_ = nullptr;
    sqlite3_vfs* real_;
    sqlite3_vfs vfs_;
    mutable std::mutex mutex_;
    std::map<std::string, std::unique_ptr<Content>> contents_;  ///< by path; also of files closed since
    bool has_power_ = true;
    int64_t syncs_ = 0;
};

}  // namespace noctule::test
