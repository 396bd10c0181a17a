// SPDX-License-Identifier: Apache-2.0
#include "core/posing/pose_body.h"

#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"
#include "core/posing/root_place.h"

namespace noctule::posing {

namespace {

constexpr double kShortest_s = 2;

/// Sensors in the order of the skeleton, so that the one above comes first.
SensorTracks fromRootOutwards(const Actor& actor, SensorTracks tracks) {
    std::ranges::stable_sort(tracks.sensors, {},
                             [&](const SensorTrack& track) { return actor.skeleton.find(track.segment); });
    return tracks;
}

std::vector<SensorPair> pairsOf(const Skeleton& skeleton, const SensorTracks& tracks) {
    std::vector<SensorPair> pairs;
    for (size_t s = 1; s < tracks.sensors.size(); ++s) {
        const std::string& segment = tracks.sensors[s].segment;
        if (segment == tracks.sensors[s - 1].segment) {
            pairs.push_back({s - 1, s});
            continue;
        }
        for (int j = skeleton.joint(skeleton.find(segment)).parent; j >= 0; j = skeleton.joint(j).parent) {
            const auto above =
                std::ranges::find(tracks.sensors, skeleton.joint(j).name, &SensorTrack::segment);
            if (above == tracks.sensors.end())
                continue;
            pairs.push_back({size_t(above - tracks.sensors.begin()), s});
            break;
        }
    }
    return pairs;
}

/// 1, and less near where a sensor comes or leaves: the sixth power, for even little of it moves a joint that
/// only its past holds.
std::vector<double> presence(const SensorTrack& track, double rate_hz, double join_s) {
    const size_t n = track.q_world_sensor.size();
    std::vector<double> weight(n);
    const double step = 1 / (std::max(join_s, 1e-3) * rate_hz);
    double up = track.has(0) ? 1 : 0;
    for (size_t i = 0; i < n; ++i)
        weight[i] = up = track.has(i) ? std::min(1.0, up + step) : 0;
    double down = track.has(n - 1) ? 1 : 0;
    for (size_t i = n; i-- > 0;) {
        down = track.has(i) ? std::min(1.0, down + step) : 0;
        weight[i] = std::pow(std::min(weight[i], down), 6);
    }
    return weight;
}

class BodyPoser {
public:
    BodyPoser(const Actor& actor, const SensorTracks& tracks, const Headings& headings,
              const Mountings& mountings, const PosingSettings& settings)
        : actor_(actor), tracks_(tracks), headings_(headings), mountings_(mountings), settings_(settings) {
        for (const SensorTrack& track : tracks.sensors) {
            joints_.push_back(actor.skeleton.find(track.segment));
            presence_.push_back(presence(track, tracks.rate_hz, settings.join_s));
        }
    }

    Result<std::vector<TimedPose>> poses(const Pose& start, const JobContext& job) const {
        PoseFit fit(actor_.skeleton, start, settings_.fit);
        std::vector<TimedPose> out;
        for (size_t i = 0; i < tracks_.size(); ++i) {
            FittedPose fitted = fit.next(attitudes(i), 1 / tracks_.rate_hz);
            TimedPose timed;
            timed.time_ns = tracks_.first_ns + std::llround(double(i) / tracks_.rate_hz * 1e9);
            timed.pose = std::move(fitted.pose);
            timed.sigma_rad = std::move(fitted.sigma_rad);
            out.push_back(std::move(timed));
            if (i % 256 == 0) {
                job.progress(double(i) / double(tracks_.size()), "Poses");
                if (job.cancelled())
                    return JobContext::cancelledError();
            }
        }
        return out;
    }

private:
    std::vector<SegmentAttitude> attitudes(size_t i) const {
        std::vector<SegmentAttitude> out;
        const Quaterniond facing = axisAngle(Vector3d::UnitY(), -mountings_.facing_rad);
        for (size_t s = 0; s < tracks_.sensors.size(); ++s)
            if (tracks_.sensors[s].has(i))
                out.push_back(
                    {joints_[s],
                     facing * headings_.turned(tracks_, s, i) * mountings_.q_segment_sensor[s].conjugate(),
                     headings_.sigma_rad[s][i], presence_[s][i]});
        return out;
    }

    const Actor& actor_;
    const SensorTracks& tracks_;
    const Headings& headings_;
    const Mountings& mountings_;
    const PosingSettings& settings_;
    std::vector<int> joints_;
    std::vector<std::vector<double>> presence_;
};

/// Takes the sensors that sit on no segment of the actor out.
Status checkTracks(const Actor& actor, SensorTracks& tracks, std::vector<std::string>& warnings) {
    std::erase_if(tracks.sensors, [&](const SensorTrack& track) {
        const bool known = !track.segment.empty() && actor.skeleton.find(track.segment) >= 0;
        if (!known)
            warnings.push_back("Sensor " + track.id + " sits on no segment of the actor and is left out.");
        return !known;
    });
    if (tracks.sensors.empty())
        return Error{ErrorKind::kUnusable, "no sensor sits on a segment of the actor",
                     "Import the recording again and say where each sensor sits (--assign names or auto)"};
    if (double(tracks.size()) < kShortest_s * tracks.rate_hz)
        return Error{ErrorKind::kUnusable, "the recording is shorter than 2 s",
                     "Stand still for a second, then move"};
    return Done{};
}

}  // namespace

Result<BodyMotion> poseBody(const Actor& actor, const SensorTracks& given,
                            const std::optional<std::pair<size_t, size_t>>& rest,
                            const PosingSettings& settings, const JobContext& job) {
    BodyMotion out;
    SensorTracks tracks = given;
    if (Status usable = checkTracks(actor, tracks, out.warnings); !usable)
        return usable.error();
    tracks = fromRootOutwards(actor, std::move(tracks));
    const auto pairs = pairsOf(actor.skeleton, tracks);
    out.standing = rest ? Standing{rest->first, rest->second, true, false} : findStanding(tracks);
    if (!rest && !out.standing.walks)
        out.warnings.push_back(
            "No walking was found: the performer is believed to stand upright in the first still second.");
    auto headings =
        agreeHeadings(tracks, pairs, standingHeadings(actor, tracks, out.standing), settings.headings, job);
    if (!headings)
        return headings.error();
    const Mountings mountings = findMountings(actor, tracks, *headings, pairs, out.standing);
    out.warnings.insert(out.warnings.end(), headings->warnings.begin(), headings->warnings.end());
    out.warnings.insert(out.warnings.end(), mountings.warnings.begin(), mountings.warnings.end());
    const BodyPoser poser(actor, tracks, *headings, mountings, settings);
    auto poses = poser.poses(standingPose(actor, out.standing.marked), job);
    if (!poses)
        return poses.error();
    out.poses = std::move(*poses);
    placeRoot(actor.skeleton, out.poses);
    return out;
}

}  // namespace noctule::posing
