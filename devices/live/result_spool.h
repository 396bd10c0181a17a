// SPDX-License-Identifier: Apache-2.0
// Holds what the live pipeline yields while its take is being recorded, to be written into the take as
// derived runs afterwards. A file without a name beside the take (1 MB a second): memory does not grow with
// the take's length.
#pragma once

#include <filesystem>
#include <vector>

#include "core/job/unnamed_file.h"
#include "core/processing/result_runs.h"

namespace noctule {

class ResultSpool {
public:
    static Result<ResultSpool> make(const std::filesystem::path& folder);

    void add(const std::vector<InertialReading>& readings);
    void add(const std::vector<RangeMeasurement>& ranges);
    void add(const std::vector<TimedPose>& poses);

    /// kDisk when something could not be written or read back.
    Status replay(ResultRuns& runs);

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
