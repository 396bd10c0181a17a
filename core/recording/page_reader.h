// SPDX-License-Identifier: Apache-2.0
// The bytes of one page of a database after the other, without SQLite (SQLite file format, section 1.6).
#pragma once

#include <cstdint>
#include <istream>
#include <limits>
#include <string>

namespace noctule {

inline constexpr int kInnerPage = 5, kRowPage = 13;  ///< kinds of pages of a table
inline constexpr int kMostLevels = 20;               ///< of a table's tree, as SQLite has it

class PageReader {
public:
    PageReader(std::istream& file, int64_t page_bytes) : file_(file), page_bytes_(page_bytes) {}

    bool read(int64_t page) {
        if (page < 1 || page > std::numeric_limits<int64_t>::max() / page_bytes_)
            return false;
        bytes_.resize(static_cast<size_t>(page_bytes_));
        file_.clear();
        file_.seekg((page - 1) * page_bytes_);
        start_ = page == 1 ? kHeaderOfFile_bytes : 0;
        return static_cast<bool>(file_.read(bytes_.data(), page_bytes_));
    }

    // Of the page that was read last.
    const std::string& bytes() const { return bytes_; }
    int64_t start() const { return start_; }  ///< of what stands on it
    int kind() const { return byte(start_); }
    int64_t entries() const { return number(start_ + 3, 2); }  ///< rows, or children but the last
    int byte(int64_t at) const {
        return at < page_bytes_ ? static_cast<unsigned char>(bytes_[static_cast<size_t>(at)]) : 0;
    }
    int64_t number(int64_t at, int length) const {
        int64_t value = 0;
        for (int i = 0; i < length; ++i)
            value = value << 8 | byte(at + i);
        return value;
    }
    /// SQLite's variable-length integer: seven bits in each byte, all eight in the ninth. `at` moves behind
    /// it.
    int64_t varint(int64_t& at) const {
        uint64_t value = 0;
        for (int i = 0; i < 8; ++i) {
            const int next = byte(at++);
            value = value << 7 | static_cast<uint64_t>(next & 127);
            if (next < 128)
                return static_cast<int64_t>(value);
        }
        return static_cast<int64_t>(value << 8 | static_cast<uint64_t>(byte(at++)));
    }

private:
    static constexpr int64_t kHeaderOfFile_bytes = 100;  ///< before what stands on page 1

    std::istream& file_;
    const int64_t page_bytes_;
    std::string bytes_;
    int64_t start_ = 0;
};

}  // namespace noctule
