// SPDX-License-Identifier: Apache-2.0
// What a filter was given and where it stood now and then, kept in a file without a name (about 0.9 MB a
// second of the default suit), so that any stretch can be filtered again without holding a long take in
// memory.
#pragma once

#include "core/estimation/manifold_filter.h"
#include "core/job/unnamed_file.h"

namespace noctule {

void putInput(UnnamedFile& file, const ManifoldFilter::StepInput& input);
/// False at the end of the file.
bool takeInput(UnnamedFile& file, ManifoldFilter::StepInput& input);
/// When what was put there cannot be taken back.
Error unreadableSpool();

class StepSpool {
public:
    explicit StepSpool(UnnamedFile file) : file_(std::move(file)) {}

    void add(const ManifoldFilter::StepInput& input);
    /// A place to come back to: what follows belongs to the stretch that begins here.
    void mark(const ManifoldFilter::Memory& memory);

    /// Since the last mark.
    int64_t steps() const { return marks_.back().steps; }
    /// The filter as it was at a mark; next() then gives that stretch's inputs. kDisk when the file cannot be
    /// read back.
    Result<ManifoldFilter::Memory> goTo(int stretch);
    /// False at the end of the stretch, or when it cannot be read back: then status() is kDisk.
    bool next(ManifoldFilter::StepInput& input);
    Status status() const;

private:
    struct Mark {
        int64_t position = 0, steps = 0;
        ManifoldFilter::Memory memory;  ///< without P, which is in the file
    };

    UnnamedFile file_;
    std::vector<Mark> marks_;
    int64_t left_ = 0;
    bool is_whole_ = true;
    Eigen::Index size_ = 0;  ///< of P
};

}  // namespace noctule
