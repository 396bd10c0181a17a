// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/take_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/processing/standing_feet.h"
#include "core/review/plot_series.h"

namespace noctule::ui {

namespace {

constexpr double kTrail_s = 1;
constexpr double kTrailStep_s = 1.0 / 30;
constexpr std::array kTrailJoints{"LeftHand", "RightHand", "LeftFoot", "RightFoot"};
constexpr float kContactRadius_m = 0.09F;

constexpr double kTagOverHead_m = 0.32;
constexpr int64_t kHeldAtEnds_ns = 500'000'000;

/// Over the head, or over the highest joint of a body without one.
Vector3d overHead(const Skeleton& skeleton, const BodyPlaces& places) {
    const std::vector<Vector3d>& joints = places.joints.p_world_joint;
    const int head = skeleton.find("Head");
    const Vector3d top =
        head >= 0 ? joints[static_cast<size_t>(head)]
                  : *std::ranges::max_element(joints, {}, [](const Vector3d& p_m) { return p_m.y(); });
    return top + kTagOverHead_m * Vector3d::UnitY();
}

std::optional<double> sigmaAt(const MotionCurve& curve, double t_s) {
    const std::vector<float>&value = curve.value.series().value, &high = curve.high.series().value;
    const size_t index = curve.value.indexAt(t_s);
    if (index >= value.size() || index >= high.size() || !std::isfinite(high[index]))
        return std::nullopt;
    return (high[index] - value[index]) / 2;
}

int64_t nanoseconds(double t_s) {
    return std::llround(t_s * 1e9);
}

}  // namespace

int ComposedScene::goodPairs() const {
    return static_cast<int>(std::count_if(pairs.begin(), pairs.end(), [](const HeardPair& pair) {
        return pair.confidence >= kGoodConfidence;
    }));
}

std::vector<Vector3d> ComposedScene::boardPoints() const {
    std::vector<Vector3d> points;
    for (const BoardPlace& place : places.boards)
        points.push_back(place.p_m);
    return points;
}

std::vector<Vector3d> ComposedScene::sourcePoints() const {
    std::vector<Vector3d> points;
    for (const SourcePlace& place : places.sources)
        points.push_back(place.p_m);
    return points;
}

void TakeScene::Track::follow(std::shared_ptr<const TimedMotion> of,
                              std::shared_ptr<const std::vector<FootContacts>> when_feet_stood) {
    if (of == motion && when_feet_stood == contacts)
        return;
    motion = std::move(of);
    contacts = std::move(when_feet_stood);
    max_gap_ns = motion ? bridgeableGap_ns(*motion) : 0;
    if (motion)
        feet = contacts ? feetAtRest(*motion, *contacts) : feetAtRest(motion->skeleton);
}

std::optional<Pose> TakeScene::Track::at(double t_s) const {
    if (!motion || motion->frames.empty())
        return std::nullopt;
    // Poses end with the last frame that all boards sent, a moment before the take: the body stays until
    // then.
    const int64_t t_ns = nanoseconds(t_s);
    const int64_t within_ns = std::clamp(t_ns, motion->frames.front().time_ns, motion->frames.back().time_ns);
    return poseAt(*motion, std::abs(t_ns - within_ns) <= kHeldAtEnds_ns ? within_ns : t_ns, max_gap_ns);
}

void TakeScene::addPairs(ComposedScene& composed, double t_s) {
    const auto ranges = review_.take().ranges();
    if (!ranges)
        return;
    const int sources = std::min(ranges->source_count, static_cast<int>(composed.places.sources.size()));
    const int boards = std::min(ranges->board_count, static_cast<int>(composed.places.boards.size()));
    composed.pair_count = sources * boards;
    for (int source = 0; source < sources; ++source)
        for (int board = 0; board < boards; ++board) {
            const PairNow now = pairAt(*ranges, source, board, t_s);
            if (now.confidence)
                composed.pairs.push_back({source, board, *now.confidence});
            if (!now.has_pulse && board == 0)
                composed.quiet_sources.push_back(source);
        }
}

void TakeScene::addTrails(ComposedScene& composed, const SceneColors& colors, double t_s) {
    const Skeleton& skeleton = shown_.motion->skeleton;
    std::array<SceneTrail, kTrailJoints.size()> trails;
    for (double t = std::max(0.0, t_s - kTrail_s); t <= t_s; t += kTrailStep_s) {
        const auto pose = shown_.at(t);
        if (!pose)
            continue;
        const GlobalPose joints = globalPose(skeleton, *pose);
        for (size_t i = 0; i < kTrailJoints.size(); ++i)
            if (const int joint = skeleton.find(kTrailJoints[i]); joint >= 0)
                trails[i].points_m.push_back(joints.p_world_joint[static_cast<size_t>(joint)].cast<float>());
    }
    for (SceneTrail& trail : trails) {
        trail.color = colors.trail;
        composed.scene.trails.push_back(std::move(trail));
    }
}

void TakeScene::addContacts(ComposedScene& composed, const SceneColors& colors, double t_s) {
    const auto feet = review_.take().contacts();
    if (!feet)
        return;
    const Skeleton& skeleton = shown_.motion->skeleton;
    for (const FootContacts& foot : *feet) {
        const int joint = skeleton.find(foot.foot);
        const bool stands = std::any_of(foot.contacts.begin(), foot.contacts.end(), [&](const auto& contact) {
            return contact.from_s <= t_s && t_s <= contact.to_s;
        });
        if (joint < 0 || !stands)
            continue;
        const auto at = static_cast<size_t>(joint);
        const Vector3d middle = composed.places.joints.p_world_joint[at] +
                                composed.places.joints.q_world_joint[at] *
                                    (0.4 * skeleton.joint(joint).end_m.value_or(Vector3d(0, 0, 0.15)));
        SceneDisc disc;
        disc.centre_m = {static_cast<float>(middle.x()), 0, static_cast<float>(middle.z())};
        disc.radius_x_m = disc.radius_z_m = kContactRadius_m;
        disc.color = colors.contact;
        composed.scene.discs.push_back(disc);
    }
}

void TakeScene::addCompared(ComposedScene& composed, const SceneColors& colors, double t_s) {
    compared_.follow(review_.take().comparedMotion(), review_.take().contacts());
    const auto pose = compared_.at(t_s);
    if (!pose)
        return;
    const BodyLook look = review_.shared().look();
    addGhost(composed.scene, colors, compared_.body.fit(look, compared_.motion->skeleton, compared_.feet),
             *pose, look.blending);
    composed.has_ghost = true;
    composed.ghost_bones = placeBody(compared_.motion->skeleton, *pose, Suit(), nullptr).bones;
}

void TakeScene::addDistance(ComposedScene& composed, int other, const Skeleton& skeleton,
                            const BodyPlaces& places, double t_s) {
    const int subject = review_.take().subject(), earlier = std::min(other, subject),
              later = std::max(other, subject);
    const auto tracks = review_.take().betweenTracks(earlier, later);
    const BetweenTrack* track = tracks ? nearestHands(*tracks) : nullptr;
    if (!track)
        return;
    const bool other_is_later = other == later;
    const int of_shown = shown_.motion->skeleton.find(other_is_later ? track->joint : track->other_joint),
              of_other = skeleton.find(other_is_later ? track->other_joint : track->joint);
    if (of_shown < 0 || of_other < 0)
        return;
    const Vector3d here = composed.places.joints.p_world_joint[static_cast<size_t>(of_shown)],
                   there = places.joints.p_world_joint[static_cast<size_t>(of_other)];
    const double distance_m = (there - here).norm();
    if (composed.distance && composed.distance->distance_m <= distance_m)
        return;
    composed.distance = ComposedScene::Distance{
        0.5 * (here + there), distance_m,        sigmaAt(track->distance, t_s), earlier, later,
        track->joint,         track->other_joint};
}

void TakeScene::addOthers(ComposedScene& composed, const SceneLayers& layers, const SceneColors& colors,
                          double t_s) {
    TakeDocument& take = review_.take();
    others_.resize(take.subjects().size());
    const BodyLook look = review_.shared().look();
    const bool has_mesh = layers.has(SceneLayer::kMesh) && (look.ours || look.worn);
    for (int i = 0; i < static_cast<int>(others_.size()); ++i) {
        Track& other = others_[static_cast<size_t>(i)];
        other.follow(i == take.subject() ? nullptr : take.motionOf(i), nullptr);
        const auto pose = other.at(t_s);
        if (!pose)
            continue;
        const Skeleton& skeleton = other.motion->skeleton;
        const TakeParty& party = take.overview()->parties[static_cast<size_t>(i)];
        const BodyPlaces places = placeBody(skeleton, *pose, party.suit, &party.calibration);
        if (i == take.sourcesOf())
            composed.places.sources = places.sources;
        addShadow(composed.scene, colors, places);
        if (has_mesh)
            addSurface(composed.scene, colors, other.body.fit(look, skeleton, other.feet), *pose,
                       look.blending);
        if (layers.has(SceneLayer::kSkeleton))
            addSkeleton(composed.scene, colors, places, !has_mesh);
        composed.tags.push_back({i, overHead(skeleton, places)});
        composed.others.extend(places.box());
        if (composed.hasBody())
            addDistance(composed, i, skeleton, places, t_s);
    }
}

/// What the rays of the room's anchors begin at.
void TakeScene::placeAnchors(ComposedScene& composed, const Pose& pose) {
    const TakeDocument& take = review_.take();
    if (take.sourcesOf() < static_cast<int>(take.subjects().size()))
        return;
    const TakeParty& room = take.overview()->parties[static_cast<size_t>(take.sourcesOf())];
    composed.places.sources = placeBody(shown_.motion->skeleton, pose, room.suit, &room.calibration).sources;
}

ComposedScene TakeScene::compose(const SceneLayers& layers) {
    const SceneColors colors = SceneColors::of(Theme::get());
    ComposedScene composed;
    TakeDocument& take = review_.take();
    const double t_s = review_.time().time();
    const auto overview = take.overview();
    composed.subject = subject_;
    const bool is_shown = subject_ == SceneSubject::kShown;
    if (overview)
        shown_.follow(is_shown ? take.shownMotion() : take.comparedMotion(), take.contacts());
    else
        shown_.follow(nullptr, nullptr);
    const auto pose = shown_.at(t_s);
    const BodyLook look = review_.shared().look();
    const bool has_mesh = layers.has(SceneLayer::kMesh) && (look.ours || look.worn);
    Scene& scene = composed.scene;
    if (pose)
        composed.places = placeBody(shown_.motion->skeleton, *pose, overview->suit, &overview->calibration);
    if (pose && !take.showsOwnPairs()) {
        composed.places.sources.clear();
        placeAnchors(composed, *pose);
    }
    addRoom(scene, colors, layers, pose ? pose->p_world_root : Vector3d::Zero());
    if (overview && is_shown && layers.has(SceneLayer::kGhost))
        addCompared(composed, colors, t_s);
    if (overview && take.isOfSeveral())
        addOthers(composed, layers, colors, t_s);
    if (!pose)
        return composed;
    if (take.isOfSeveral())
        composed.tags.push_back({take.subject(), overHead(shown_.motion->skeleton, composed.places)});
    addShadow(scene, colors, composed.places);
    if (is_shown && layers.has(SceneLayer::kContacts))
        addContacts(composed, colors, t_s);
    if (has_mesh)
        addSurface(scene, colors, shown_.body.fit(look, shown_.motion->skeleton, shown_.feet), *pose,
                   look.blending);
    if (layers.has(SceneLayer::kSkeleton))
        addSkeleton(scene, colors, composed.places, !has_mesh);
    if (layers.has(SceneLayer::kTrails))
        addTrails(composed, colors, t_s);
    if (is_shown)
        addPairs(composed, t_s);
    if (layers.has(SceneLayer::kRays))
        addRays(scene, composed.places, composed.pairs, review_.selection().source(),
                review_.selection().board());
    if (layers.has(SceneLayer::kBoards))
        addSuit(scene, colors, composed.places);
    return composed;
}

}  // namespace noctule::ui
