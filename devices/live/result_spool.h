// SPDX-License-Identifier: Apache-2.0
// Holds what the live pipeline yields while its take is being recorded, to be written into the take as
// derived runs afterwards. A file without a name beside the take (1 MB a second): memory does not grow with
// the take's length, and a crash leaves nothing behind. The bytes are those of this process and go nowhere
// else.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

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
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    explicit ResultSpool(std::FILE* file) : file_(file) {}
    template <class T>
    void put(const T& value);
    template <class T>
    bool take(T& value);
    template <class Row>
    void putRows(char kind, const std::vector<Row>& rows);
    template <class Row>
    bool takeRows(std::vector<Row>& rows);
    bool takePoses(std::vector<TimedPose>& poses);

    std::unique_ptr<std::FILE, Closer> file_;
    bool failed_ = false;
};

}  // namespace noctule
