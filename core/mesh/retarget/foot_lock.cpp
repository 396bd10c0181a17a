// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/retarget/foot_lock.h"

#include <algorithm>
#include <cmath>

#include "core/math/easing.h"

namespace noctule {
namespace {

constexpr double kEase_s = 0.06;   ///< over which a foot is taken hold of, and let go
constexpr double kFade_s = 0.4;    ///< before the first and after the last stand
constexpr double kSpeed_s = 0.02;  ///< to either side, over which a point's speed is taken
constexpr double kStill_m = 1e-4;  ///< below which two points stand alike

Vector3d level(const Vector3d& v) {
    return {v.x(), 0, v.z()};
}

/// The frames in which a foot stands.
struct Stand {
    size_t first = 0, last = 0;
};

/// One leg over all frames.
class LegTrack {
public:
    LegTrack(const std::vector<std::array<LegPlaces, 2>>& legs, size_t side, double scale,
             double frame_time_s)
        : legs_(legs), side_(side), scale_(scale), frame_time_s_(frame_time_s) {}

    size_t frames() const { return legs_.size(); }
    const LegPlaces& at(size_t frame) const { return legs_[frame][side_]; }

    std::vector<Stand> stands(const std::vector<FootPlant>& plants) const {
        std::vector<Stand> stands;
        const auto last = static_cast<double>(frames() - 1);
        for (const FootPlant& plant : plants) {
            const double from = std::max(0.0, std::ceil(plant.from_s / frame_time_s_));
            const double to = std::min(last, std::floor(plant.to_s / frame_time_s_));
            if (from < to)
                stands.push_back({static_cast<size_t>(from), static_cast<size_t>(to)});
        }
        return stands;
    }

    /// Where the ankle is moved to, per frame, world.
    std::vector<Vector3d> shifts(const std::vector<Stand>& stands) const {
        std::vector<Vector3d> shifts(frames(), Vector3d::Zero());
        for (const Stand& stand : stands)
            holdStill(stand, shifts);
        fade(stands, shifts);
        for (const Stand& stand : stands)
            for (size_t f = stand.first; f <= stand.last; ++f)
                shifts[f].y() = hold(stand, static_cast<double>(f)) *
                                (scale_ * lowest(at(f).sole_ours) - lowest(at(f).sole));
        return shifts;
    }

private:
    static double lowest(const std::array<Vector3d, 2>& sole) { return std::min(sole[0].y(), sole[1].y()); }

    /// 0 at the ends of a stand, 1 within it.
    double hold(const Stand& stand, double frame) const {
        const double ease = kEase_s / frame_time_s_;
        return eased((frame - static_cast<double>(stand.first)) / ease) *
               eased((static_cast<double>(stand.last) - frame) / ease);
    }

    /// Of heel and toes the share of each in standing between a frame and the next: the slower has more.
    std::array<double, 2> standing(const Stand& stand, size_t frame) const {
        const auto wide = static_cast<size_t>(std::lround(kSpeed_s / frame_time_s_));
        const size_t from = std::max(stand.first, frame - std::min(frame, wide));
        const size_t to = std::min(stand.last, frame + 1 + wide);
        std::array<double, 2> way{};
        for (size_t i = 0; i < 2; ++i)
            way[i] = (at(to).sole_ours[i] - at(from).sole_ours[i]).squaredNorm() + kStill_m * kStill_m;
        return {way[1] / (way[0] + way[1]), way[0] / (way[0] + way[1])};
    }

    /// The shift undoes, step by step, what the standing point would slide: all that this body adds, and what
    /// our own foot slid as far as that is little. Its mean over the stand is zero.
    void holdStill(const Stand& stand, std::vector<Vector3d>& shifts) const {
        const size_t count = stand.last - stand.first + 1;
        std::vector<Vector3d> added(count, Vector3d::Zero()), own(count, Vector3d::Zero());
        for (size_t n = 0; n + 1 < count; ++n) {
            const size_t f = stand.first + n;
            const std::array<double, 2> share = standing(stand, f);
            Vector3d theirs = Vector3d::Zero(), ours = Vector3d::Zero();
            for (size_t i = 0; i < 2; ++i) {
                theirs += share[i] * level(at(f + 1).sole[i] - at(f).sole[i]);
                ours += share[i] * scale_ * level(at(f + 1).sole_ours[i] - at(f).sole_ours[i]);
            }
            const double held = hold(stand, static_cast<double>(f) + 0.5);
            added[n + 1] = added[n] - held * (theirs - ours);
            own[n + 1] = own[n] - held * ours;
        }
        const double far = centre(own) / (scale_ * kMostOwnSlide_m);
        centre(added);
        for (size_t n = 0; n < count; ++n)
            shifts[stand.first + n] = added[n] + own[n] / std::max(1.0, far);
    }

    /// Around their mean; the largest distance from it.
    static double centre(std::vector<Vector3d>& points) {
        Vector3d mean = Vector3d::Zero();
        for (const Vector3d& p : points)
            mean += p / static_cast<double>(points.size());
        double far = 0;
        for (Vector3d& p : points) {
            p -= mean;
            far = std::max(far, p.norm());
        }
        return far;
    }

    /// From stand to stand, and to nothing at both ends.
    void fade(const std::vector<Stand>& stands, std::vector<Vector3d>& shifts) const {
        if (stands.empty())
            return;
        const double fade = kFade_s / frame_time_s_;
        const size_t begin = stands.front().first, end = stands.back().last;
        for (size_t f = 0; f < begin; ++f)
            shifts[f] = eased(1 - static_cast<double>(begin - f) / fade) * shifts[begin];
        for (size_t f = end + 1; f < frames(); ++f)
            shifts[f] = eased(1 - static_cast<double>(f - end) / fade) * shifts[end];
        for (size_t s = 0; s + 1 < stands.size(); ++s) {
            const size_t from = stands[s].last, to = stands[s + 1].first;
            for (size_t f = from + 1; f < to; ++f) {
                const double share = eased(static_cast<double>(f - from) / static_cast<double>(to - from));
                shifts[f] = (1 - share) * shifts[from] + share * shifts[to];
            }
        }
    }

    const std::vector<std::array<LegPlaces, 2>>& legs_;
    size_t side_;
    double scale_, frame_time_s_;
};

/// Midway between the nearest curves above and below that nowhere rise or fall by more than `step` a frame.
std::vector<double> withSlope(const std::vector<double>& values, double step) {
    std::vector<double> above = values, below = values;
    const auto follow = [&](size_t f, size_t before) {
        above[f] = std::max(above[f], above[before] - step);
        below[f] = std::min(below[f], below[before] + step);
    };
    for (size_t f = 1; f < values.size(); ++f)
        follow(f, f - 1);
    for (size_t f = values.size() - 1; f-- > 0;)
        follow(f, f + 1);
    for (size_t f = 0; f < values.size(); ++f)
        above[f] = (above[f] + below[f]) / 2;
    return above;
}

}  // namespace

std::vector<FootCorrections> lockFeet(const Retargeter& retargeter, const StandingFeet& feet) {
    const std::vector<Pose>& frames = feet.frames;
    std::vector<FootCorrections> corrections(frames.size());
    if (frames.empty())
        return corrections;
    std::vector<std::array<LegPlaces, 2>> legs;
    for (const Pose& pose : frames)
        legs.push_back(retargeter.legs(pose));
    for (size_t side = 0; side < 2; ++side) {
        const LegTrack track(legs, side, retargeter.scale(), feet.frame_time_s);
        const std::vector<Vector3d> shifts = track.shifts(track.stands(feet.plants[side]));
        std::vector<double> knees;
        for (size_t f = 0; f < frames.size(); ++f)
            knees.push_back(track.at(f).kneeTurn(shifts[f]));
        knees = withSlope(knees, kMostKnee_rad_per_s * feet.frame_time_s);
        for (size_t f = 0; f < frames.size(); ++f)
            corrections[f][side] = {frames[f].q_parent_joint[0].conjugate() * shifts[f], knees[f]};
    }
    return corrections;
}

}  // namespace noctule
