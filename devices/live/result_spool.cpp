// SPDX-License-Identifier: Apache-2.0
#include "devices/live/result_spool.h"

#include <stdlib.h>
#include <unistd.h>

#include <type_traits>

namespace noctule {
namespace {

constexpr char kReadings = 'i', kRanges = 'r', kPoses = 'p';

}  // namespace

Result<ResultSpool> ResultSpool::make(const std::filesystem::path& folder) {
    std::string name = (folder / ".live-results-XXXXXX").string();
    const int descriptor = mkstemp(name.data());
    std::FILE* file = descriptor < 0 ? nullptr : fdopen(descriptor, "w+b");
    if (descriptor >= 0)
        unlink(name.c_str());
    if (!file) {
        if (descriptor >= 0)
            close(descriptor);
        return Error{ErrorKind::kDisk, folder.string() + ": live results cannot be kept there",
                     "Check that you may write there, or process the take afterwards"};
    }
    return ResultSpool(file);
}

template <class T>
void ResultSpool::put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    failed_ = failed_ || std::fwrite(&value, sizeof value, 1, file_.get()) != 1;
}

template <class T>
bool ResultSpool::take(T& value) {
    return std::fread(&value, sizeof value, 1, file_.get()) == 1;
}

template <class Row>
void ResultSpool::putRows(char kind, const std::vector<Row>& rows) {
    if (rows.empty())
        return;
    put(kind);
    put(rows.size());
    for (const Row& row : rows)
        put(row);
}

template <class Row>
bool ResultSpool::takeRows(std::vector<Row>& rows) {
    size_t count = 0;
    if (!take(count))
        return false;
    rows.resize(count);
    for (Row& row : rows)
        if (!take(row))
            return false;
    return true;
}

void ResultSpool::add(const std::vector<InertialReading>& readings) {
    putRows(kReadings, readings);
}

void ResultSpool::add(const std::vector<RangeMeasurement>& ranges) {
    putRows(kRanges, ranges);
}

void ResultSpool::add(const std::vector<TimedPose>& poses) {
    if (poses.empty())
        return;
    put(kPoses);
    put(poses.size());
    for (const TimedPose& timed : poses) {
        require(timed.pose.has_value(), "a live pose must be there");
        put(timed.time_ns);
        for (const double coordinate : timed.pose->p_world_root)
            put(coordinate);
        put(timed.pose->q_parent_joint.size());
        for (const Quaterniond& q : timed.pose->q_parent_joint)
            for (const double coefficient : q.coeffs())
                put(coefficient);
        put(timed.sigma_rad.size());
        for (const double sigma : timed.sigma_rad)
            put(sigma);
    }
}

bool ResultSpool::takePoses(std::vector<TimedPose>& poses) {
    size_t count = 0;
    if (!take(count))
        return false;
    poses.resize(count);
    for (TimedPose& timed : poses) {
        bool whole = take(timed.time_ns);
        timed.pose.emplace();
        for (double& coordinate : timed.pose->p_world_root)
            whole = whole && take(coordinate);
        size_t joints = 0, sigmas = 0;
        whole = whole && take(joints);
        timed.pose->q_parent_joint.resize(joints);
        for (Quaterniond& q : timed.pose->q_parent_joint)
            for (double& coefficient : q.coeffs())
                whole = whole && take(coefficient);
        whole = whole && take(sigmas);
        timed.sigma_rad.resize(sigmas);
        for (double& sigma : timed.sigma_rad)
            whole = whole && take(sigma);
        if (!whole)
            return false;
    }
    return true;
}

Status ResultSpool::replay(ResultRuns& runs) {
    const Error lost{ErrorKind::kDisk, "the results of the live pipeline could not be kept on the disk",
                     "Process the take instead"};
    if (failed_ || std::fflush(file_.get()) != 0)
        return lost;
    std::rewind(file_.get());
    std::vector<InertialReading> readings;
    std::vector<RangeMeasurement> ranges;
    std::vector<TimedPose> poses;
    for (char kind = 0; take(kind);) {
        const bool whole = kind == kReadings ? takeRows(readings)
                           : kind == kRanges ? takeRows(ranges)
                                             : takePoses(poses);
        if (!whole)
            return lost;
        const Status written = kind == kReadings ? runs.write(readings)
                               : kind == kRanges ? runs.write(ranges)
                                                 : runs.write(poses);
        if (!written)
            return written;
    }
    return std::ferror(file_.get()) ? Status(lost) : Status(Done{});
}

}  // namespace noctule
