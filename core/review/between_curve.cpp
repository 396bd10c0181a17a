// SPDX-License-Identifier: Apache-2.0
#include "core/review/between_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/processing/evaluate_between.h"
#include "core/review/review_file.h"

namespace noctule {
namespace {

struct Ends {
    const char *joint, *other_joint;
    int of_one, of_other;  ///< indices of their joints
};

std::vector<Ends> endsOf(const Skeleton& one, const Skeleton& other) {
    std::vector<Ends> ends;
    for (const auto& [joint, other_joint] : kComparedEnds) {
        const Ends found{joint, other_joint, one.find(joint), other.find(other_joint)};
        if (found.of_one >= 0 && found.of_other >= 0)
            ends.push_back(found);
    }
    return ends;
}

/// Sigma of a distance at the times at which a run states it.
struct StatedSigma {
    std::vector<int64_t> time_ns;
    std::vector<double> sigma_m;

    /// Linear between two rows; NaN outside of them.
    double at(int64_t when_ns) const {
        const auto after = std::ranges::lower_bound(time_ns, when_ns);
        if (after == time_ns.end())
            return kNoValue;
        const auto index = static_cast<size_t>(after - time_ns.begin());
        if (*after == when_ns)
            return sigma_m[index];
        if (index == 0)
            return kNoValue;
        const double share = static_cast<double>(when_ns - time_ns[index - 1]) /
                             static_cast<double>(time_ns[index] - time_ns[index - 1]);
        return std::lerp(sigma_m[index - 1], sigma_m[index], share);
    }
};

class TwoBodies {
public:
    TwoBodies(TimedMotion one, TimedMotion other) : one_(std::move(one)), other_(std::move(other)) {}

    std::vector<BetweenTrack> tracks(const std::vector<RelativeRow>& stated, const JobContext& job) const {
        std::vector<BetweenTrack> tracks;
        for (const Ends& ends : endsOf(one_.skeleton, other_.skeleton)) {
            if (job.cancelled())
                break;
            tracks.push_back(track(ends, sigmas(ends, stated)));
        }
        return tracks;
    }

private:
    /// From the one's joint to the other's, in the frame of the one's root.
    std::optional<Vector3d> vectorAt(const Ends& ends, int64_t time_ns, PoseSampler& of_one,
                                     PoseSampler& of_other) const {
        const auto pose = of_one.at(time_ns), other = of_other.at(time_ns);
        if (!pose || !other)
            return std::nullopt;
        const Vector3d from =
            globalPose(one_.skeleton, *pose).p_world_joint[static_cast<size_t>(ends.of_one)];
        const Vector3d to =
            globalPose(other_.skeleton, *other).p_world_joint[static_cast<size_t>(ends.of_other)];
        return pose->q_parent_joint[0].conjugate() * (to - from);
    }

    StatedSigma sigmas(const Ends& ends, const std::vector<RelativeRow>& stated) const {
        PoseSampler of_one(one_, bridgeableGap_ns(one_)), of_other(other_, bridgeableGap_ns(other_));
        StatedSigma found;
        for (const RelativeRow& row : stated) {
            if (row.joint != ends.joint || row.other_joint != ends.other_joint)
                continue;
            const auto vector = vectorAt(ends, row.time_ns, of_one, of_other);
            if (!vector || vector->norm() < 1e-6)
                continue;
            const Vector3d along = vector->normalized();
            found.time_ns.push_back(row.time_ns);
            found.sigma_m.push_back(std::sqrt(std::max(0.0, along.dot(row.cov_m2 * along))));
        }
        return found;
    }

    BetweenTrack track(const Ends& ends, const StatedSigma& sigma) const {
        PoseSampler of_one(one_, bridgeableGap_ns(one_)), of_other(other_, bridgeableGap_ns(other_));
        BetweenTrack track{ends.joint, ends.other_joint, std::numeric_limits<double>::infinity(), {}};
        std::vector<double> t_s;
        std::vector<float> value, low, high;
        for (const TimedPose& frame : one_.frames) {
            const auto vector = vectorAt(ends, frame.time_ns, of_one, of_other);
            const double distance_m = vector ? vector->norm() : kNoValue;
            const double band_m = 2 * sigma.at(frame.time_ns);
            if (vector)
                track.least_m = std::min(track.least_m, distance_m);
            t_s.push_back(static_cast<double>(frame.time_ns) * 1e-9);
            value.push_back(static_cast<float>(distance_m));
            low.push_back(static_cast<float>(distance_m - band_m));
            high.push_back(static_cast<float>(distance_m + band_m));
        }
        track.distance.unit = CurveUnit::kMetres;
        if (!sigma.time_ns.empty()) {
            track.distance.low = SeriesPyramid(makeSeries(t_s, std::move(low)));
            track.distance.high = SeriesPyramid(makeSeries(t_s, std::move(high)));
        }
        track.distance.value = SeriesPyramid(makeSeries(std::move(t_s), std::move(value)));
        return track;
    }

    TimedMotion one_, other_;
};

}  // namespace

Result<std::vector<BetweenTrack>> loadBetween(const TakeView& view, std::optional<int64_t> run,
                                              int other_suit, const JobContext& job) {
    auto one = loadPoses(view, run, job);
    if (!one)
        return one.error();
    auto other = loadPoses({view.path, other_suit}, run, job);
    if (!other)
        return other.error();
    std::vector<RelativeRow> stated;
    if (run) {
        const auto viewed = ViewedTake::open(view);
        if (!viewed)
            return viewed.error();
        auto rows = viewed->take.relatives(*run);
        if (!rows)
            return rows.error();
        std::erase_if(*rows, [&](const RelativeRow& row) { return row.other_suit != other_suit; });
        stated = std::move(*rows);
    }
    auto tracks = TwoBodies(std::move(*one), std::move(*other)).tracks(stated, job);
    if (job.cancelled())
        return JobContext::cancelledError();
    return tracks;
}

const BetweenTrack* nearestHands(const std::vector<BetweenTrack>& tracks) {
    const BetweenTrack* nearest = nullptr;
    for (const BetweenTrack& track : tracks)
        if (track.joint != "Hips" && (!nearest || track.least_m < nearest->least_m))
            nearest = &track;
    return nearest;
}

}  // namespace noctule
