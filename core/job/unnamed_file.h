// SPDX-License-Identifier: Apache-2.0
// A file without a name for what would not fit into memory: nothing else sees it, and a crash leaves nothing
// behind. Its bytes are those of this process and go nowhere else.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <type_traits>

#include "core/job/result.h"

namespace noctule {

class UnnamedFile {
public:
    /// In `folder`; kDisk, with `what` ("live results") and the remedy, when the system refuses.
    static Result<UnnamedFile> make(const std::filesystem::path& folder, const std::string& what,
                                    const std::string& remedy);

    template <class T>
    void put(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        putBytes(&value, sizeof value);
    }
    /// False at the end of the file.
    template <class T>
    bool take(T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        return takeBytes(&value, sizeof value);
    }
    void putBytes(const void* bytes, size_t size);
    bool takeBytes(void* bytes, size_t size);

    /// Where the next byte goes; writing and reading alternate only across seek().
    int64_t position() const;
    void seek(int64_t position);
    /// False once something could not be written or read for another reason than the file's end.
    bool good();

private:
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    explicit UnnamedFile(std::FILE* file) : file_(file) {}

    std::unique_ptr<std::FILE, Closer> file_;
    bool failed_ = false;
};

}  // namespace noctule
