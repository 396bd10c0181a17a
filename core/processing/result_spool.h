// SPDX-License-Identifier: Apache-2.0
// Holds what the pipeline yields while its take is being recorded or read, to be written into the take as
// derived runs afterwards: the take stays free for other programs. A file without a name beside the take (1
// MB a second): memory does not grow with the take's length.
#pragma once

#include <filesystem>
#include <vector>

#include "core/acoustics/range.h"
#include "core/inertial/reading.h"
#include "core/job/unnamed_file.h"
#include "core/motion/timed_poses.h"

namespace noctule {

/// Takes results in the order in which they came.
class ResultSink {
public:
    virtual ~ResultSink() = default;
    virtual Status write(const std::vector<InertialReading>& readings) = 0;
    virtual Status write(const std::vector<RangeMeasurement>& ranges) = 0;
    virtual Status write(const std::vector<TimedPose>& poses) = 0;
};

class ResultSpool {
public:
    static Result<ResultSpool> make(const std::filesystem::path& folder);

    void add(const std::vector<InertialReading>& readings);
    void add(const std::vector<RangeMeasurement>& ranges);
    void add(const std::vector<TimedPose>& poses);

    /// kDisk when something could not be written or read back.
    Status replay(ResultSink& runs);

private:
    explicit ResultSpool(UnnamedFile file) : file_(std::move(file)) {}
    template <class Row>
    void putRows(char kind, const std::vector<Row>& rows);
    template <class Row>
    bool takeRows(std::vector<Row>& rows);
    bool takePoses(std::vector<TimedPose>& poses);

    UnnamedFile file_;
};

}  // namespace noctule
