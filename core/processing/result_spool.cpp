// SPDX-License-Identifier: Apache-2.0
#include "core/processing/result_spool.h"

namespace noctule {
namespace {

constexpr char kReadings = 'i', kRanges = 'r', kPoses = 'p';

}  // namespace

Result<ResultSpool> ResultSpool::make(const std::filesystem::path& folder) {
    auto file = UnnamedFile::make(folder, "results", "Check that you may write there and that it has room");
    if (!file)
        return file.error();
    return ResultSpool(std::move(*file));
}

template <class Row>
void ResultSpool::putRows(char kind, const std::vector<Row>& rows) {
    if (rows.empty())
        return;
    file_.put(kind);
    file_.put(rows.size());
    for (const Row& row : rows)
        file_.put(row);
}

template <class Row>
bool ResultSpool::takeRows(std::vector<Row>& rows) {
    size_t count = 0;
    if (!file_.take(count))
        return false;
    rows.resize(count);
    for (Row& row : rows)
        if (!file_.take(row))
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
    file_.put(kPoses);
    file_.put(poses.size());
    for (const TimedPose& timed : poses) {
        require(timed.pose.has_value(), "a live pose must be there");
        file_.put(timed.time_ns);
        for (const double coordinate : timed.pose->p_world_root)
            file_.put(coordinate);
        file_.put(timed.pose->q_parent_joint.size());
        for (const Quaterniond& q : timed.pose->q_parent_joint)
            for (const double coefficient : q.coeffs())
                file_.put(coefficient);
        file_.put(timed.sigma_rad.size());
        for (const double sigma : timed.sigma_rad)
            file_.put(sigma);
    }
}

bool ResultSpool::takePoses(std::vector<TimedPose>& poses) {
    size_t count = 0;
    if (!file_.take(count))
        return false;
    poses.resize(count);
    for (TimedPose& timed : poses) {
        bool whole = file_.take(timed.time_ns);
        timed.pose.emplace();
        for (double& coordinate : timed.pose->p_world_root)
            whole = whole && file_.take(coordinate);
        size_t joints = 0, sigmas = 0;
        whole = whole && file_.take(joints);
        timed.pose->q_parent_joint.resize(joints);
        for (Quaterniond& q : timed.pose->q_parent_joint)
            for (double& coefficient : q.coeffs())
                whole = whole && file_.take(coefficient);
        whole = whole && file_.take(sigmas);
        timed.sigma_rad.resize(sigmas);
        for (double& sigma : timed.sigma_rad)
            whole = whole && file_.take(sigma);
        if (!whole)
            return false;
    }
    return true;
}

Status ResultSpool::replay(ResultSink& runs) {
    const Error lost{ErrorKind::kDisk, "the results could not be kept beside the take",
                     "Free some space there and process the take"};
    if (!file_.good())
        return lost;
    file_.seek(0);
    std::vector<InertialReading> readings;
    std::vector<RangeMeasurement> ranges;
    std::vector<TimedPose> poses;
    for (char kind = 0; file_.take(kind);) {
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
    return file_.good() ? Status(Done{}) : Status(lost);
}

}  // namespace noctule
