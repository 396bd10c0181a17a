// SPDX-License-Identifier: Apache-2.0
#include "core/motion/foot_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>

#include "core/body/joint_names.h"

namespace noctule {
namespace {

constexpr double kSpeedReach_s = 0.02;  ///< to either side
constexpr double kLevelReach_s = 0.6;   ///< to either side: longer than a jump, short against the drift
constexpr size_t kPoints = 2;           ///< ankle and tip of the toes

/// A point fixed to a joint.
struct FixedPoint {
    int joint = -1;
    Vector3d p_joint_m = Vector3d::Zero();
};

std::array<FixedPoint, kPoints> pointsOf(const Skeleton& skeleton, int foot, const std::string& side) {
    const int toes = findByAnyName(skeleton, side + "ToeBase");
    const int last = toes >= 0 ? toes : foot;
    return {{{foot, Vector3d::Zero()}, {last, skeleton.joint(last).end_m.value_or(Vector3d::Zero())}}};
}

/// Where a point was in every frame, how high above its level and how fast; NaN where nothing was seen.
struct Track {
    std::vector<Vector3d> p_world_m;
    std::vector<double> height_m, speed_m_per_s;
};

double lowest(const std::vector<const Track*>& same_points, size_t frame) {
    double height_m = std::numeric_limits<double>::infinity();
    for (const Track* track : same_points)
        height_m = std::fmin(height_m, track->p_world_m[frame].y());
    return height_m;
}

/// The lowest that any foot's point of a kind was around each frame (a sliding minimum).
std::vector<double> levels(const std::vector<const Track*>& same_points,
                           const std::vector<TimedPose>& frames) {
    const auto reach_ns = static_cast<int64_t>(kLevelReach_s * 1e9);
    std::vector<double> level_m;
    std::deque<std::pair<int64_t, double>> rising;  // times and heights that may still be the lowest
    size_t next = 0;
    for (const TimedPose& frame : frames) {
        for (; next < frames.size() && frames[next].time_ns <= frame.time_ns + reach_ns; ++next) {
            const double height_m = lowest(same_points, next);
            while (!rising.empty() && rising.back().second >= height_m)
                rising.pop_back();
            rising.emplace_back(frames[next].time_ns, height_m);
        }
        while (rising.front().first < frame.time_ns - reach_ns)
            rising.pop_front();
        level_m.push_back(rising.front().second);
    }
    return level_m;
}

void finish(Track& track, const std::vector<double>& level_m, const std::vector<TimedPose>& frames,
            size_t reach) {
    const size_t count = frames.size();
    for (size_t i = 0; i < count; ++i) {
        const size_t before = i - std::min(i, reach), after = std::min(count - 1, i + reach);
        const double step_s = static_cast<double>(frames[after].time_ns - frames[before].time_ns) * 1e-9;
        track.height_m.push_back(track.p_world_m[i].y() - level_m[i]);
        track.speed_m_per_s.push_back((track.p_world_m[after] - track.p_world_m[before]).norm() / step_s);
    }
}

class FootWatcher {
public:
    FootWatcher(const TimedMotion& motion, const ContactSettings& settings, std::array<Track, kPoints> tracks)
        : motion_(motion), settings_(settings), tracks_(std::move(tracks)) {}

    std::vector<FootContact> contacts() const {
        std::vector<FootContact> contacts;
        for (const auto& [first, last] : standing())
            if (seconds(last) - seconds(first) >= settings_.least_contact_s)
                contacts.push_back({seconds(first), seconds(last), slide(first, last)});
        return contacts;
    }

    /// Of a contact that somebody else has found.
    double slideWithin(const FootContact& contact) const {
        const auto frameAt = [&](double t_s) {
            const auto found =
                std::ranges::lower_bound(motion_.frames, std::llround(t_s * 1e9), {}, &TimedPose::time_ns);
            return static_cast<size_t>(found - motion_.frames.begin());
        };
        const size_t first = frameAt(contact.from_s), end = frameAt(contact.to_s);
        return first < end ? slide(first, end - 1) : 0;
    }

private:
    using Span = std::pair<size_t, size_t>;  // frames, both included

    double seconds(size_t frame) const { return static_cast<double>(motion_.frames[frame].time_ns) * 1e-9; }

    /// Comparisons with NaN are false: what is not seen does not stand.
    bool stands(const Track& track, size_t frame, bool already) const {
        return track.height_m[frame] <= (already ? settings_.leave_height_m : settings_.touch_height_m) &&
               track.speed_m_per_s[frame] <=
                   (already ? settings_.leave_speed_m_per_s : settings_.touch_speed_m_per_s);
    }

    /// Spans of standing, with flights too short to be true filled.
    std::vector<Span> standing() const {
        std::vector<Span> spans;
        bool stood = false, unseen_since = false;
        for (size_t i = 0; i < motion_.frames.size(); ++i) {
            const bool now = std::any_of(tracks_.begin(), tracks_.end(),
                                         [&](const Track& track) { return stands(track, i, stood); });
            unseen_since = unseen_since || !tracks_[0].p_world_m[i].allFinite();
            const bool goes_on = now && !unseen_since && !spans.empty() &&
                                 seconds(i) - seconds(spans.back().second) < settings_.least_flight_s;
            if (now && (stood || goes_on))
                spans.back().second = i;
            else if (now)
                spans.emplace_back(i, i);
            stood = now;
            unseen_since = unseen_since && !now;
        }
        return spans;
    }

    double slide(size_t first, size_t last) const {
        const size_t end = (last - first) / 5;  // where the foot comes down and rolls off
        first += end, last -= end;
        std::vector<Vector3d> longest;
        for (const Track& track : tracks_) {
            std::vector<Vector3d> places;
            for (size_t i = first; i <= last; ++i)
                if (stands(track, i, true))
                    places.emplace_back(track.p_world_m[i].x(), 0, track.p_world_m[i].z());
            if (places.size() > longest.size())
                longest = std::move(places);
        }
        Vector3d mean = Vector3d::Zero();
        for (const Vector3d& place : longest)
            mean += place / static_cast<double>(longest.size());
        double farthest = 0;
        for (const Vector3d& place : longest)
            farthest = std::max(farthest, (place - mean).norm());
        return farthest;
    }

    const TimedMotion& motion_;
    const ContactSettings settings_;
    std::array<Track, kPoints> tracks_;
};

struct Foot {
    std::string name;
    std::array<FixedPoint, kPoints> points;
    std::array<Track, kPoints> tracks{};
};

void follow(const TimedMotion& motion, std::vector<Foot>& feet) {
    const Vector3d nowhere = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    for (const TimedPose& frame : motion.frames) {
        const bool seen = frame.pose && isUsable(*frame.pose);
        const GlobalPose global = seen ? globalPose(motion.skeleton, *frame.pose) : GlobalPose{};
        for (Foot& foot : feet)
            for (size_t p = 0; p < kPoints; ++p) {
                const auto joint = static_cast<size_t>(foot.points[p].joint);
                foot.tracks[p].p_world_m.push_back(
                    seen ? Vector3d(global.p_world_joint[joint] +
                                    global.q_world_joint[joint] * foot.points[p].p_joint_m)
                         : nowhere);
            }
    }
}

void addHeightsAndSpeeds(const TimedMotion& motion, std::vector<Foot>& feet) {
    const double step_s = static_cast<double>(usualStep_ns(motion)) * 1e-9;
    const size_t reach =
        step_s > 0 ? std::max<size_t>(1, static_cast<size_t>(kSpeedReach_s / step_s + 0.5)) : 1;
    for (size_t p = 0; p < kPoints; ++p) {
        std::vector<const Track*> same_points;
        for (const Foot& foot : feet)
            same_points.push_back(&foot.tracks[p]);
        const std::vector<double> level_m = levels(same_points, motion.frames);
        for (Foot& foot : feet)
            finish(foot.tracks[p], level_m, motion.frames, reach);
    }
}

/// Those that the skeleton has, followed through the motion.
std::vector<Foot> followedFeet(const TimedMotion& motion) {
    std::vector<Foot> feet;
    for (const std::string side : {"Left", "Right"})
        if (const int joint = findByAnyName(motion.skeleton, side + "Foot"); joint >= 0)
            feet.push_back({side + "Foot", pointsOf(motion.skeleton, joint, side)});
    follow(motion, feet);
    addHeightsAndSpeeds(motion, feet);
    return feet;
}

}  // namespace

std::vector<FootContacts> findFootContacts(const TimedMotion& motion, const ContactSettings& settings) {
    std::vector<Foot> feet = followedFeet(motion);
    std::vector<FootContacts> found;
    for (Foot& foot : feet)
        found.push_back({foot.name, FootWatcher(motion, settings, std::move(foot.tracks)).contacts()});
    return found;
}

void measureSlides(const TimedMotion& motion, std::vector<FootContacts>& feet) {
    for (Foot& followed : followedFeet(motion)) {
        const FootWatcher watcher(motion, {}, std::move(followed.tracks));
        for (FootContacts& foot : feet)
            if (foot.foot == followed.name)
                for (FootContact& contact : foot.contacts)
                    contact.slide_m = watcher.slideWithin(contact);
    }
}

double meanSlide_m(const std::vector<FootContacts>& feet) {
    double sum_m = 0;
    size_t count = 0;
    for (const FootContacts& foot : feet) {
        for (const FootContact& contact : foot.contacts)
            sum_m += contact.slide_m;
        count += foot.contacts.size();
    }
    return count == 0 ? 0 : sum_m / static_cast<double>(count);
}

}  // namespace noctule
