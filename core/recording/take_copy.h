// SPDX-License-Identifier: Apache-2.0
// A take's copy that is worked on before it gets its name; gone again unless published.
#pragma once

#include <string>

#include "core/job/job.h"

namespace noctule {

class Database;

class TakeCopy {
public:
    /// Copies `original`, and the write-ahead log beside it if there is one, next to `path`.
    static Result<TakeCopy> make(const std::string& original, const std::string& path, const JobContext& job);
    TakeCopy(TakeCopy&& other) noexcept;
    TakeCopy& operator=(TakeCopy&&) = delete;
    ~TakeCopy();

    /// Of the file to work on, for the time being.
    const std::string& path() const { return aside_; }
    /// An error about that file, told about the original; of a full disk, about the file to be made.
    Error named(Error error) const;
    /// Brings what stands in a copied log into the file, so that it is complete by itself. Nobody may have it
    /// open. Only a file without a log beside it can be published. Works also where the file is damaged.
    Status foldLog();
    /// For one that cannot be read.
    void dropLog();
    Status publish(bool overwrite);

private:
    void makeRoomForLog(const Database& database) const;
    TakeCopy(std::string original, std::string path, std::string aside);

    std::string original_, path_, aside_;  ///< aside empty: nothing to remove
};

}  // namespace noctule
