// SPDX-License-Identifier: Apache-2.0
// The scene of the take under review at a time: its body, the ghost of what it is compared with, rays, trails
// and contacts, as far as they are loaded and switched on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/timed_poses.h"
#include "ui/models/review_context.h"
#include "ui/scene/dressed_body.h"

namespace noctule::ui {

/// One picture and what can be said and picked in it.
struct ComposedScene {
    Scene scene;
    BodyPlaces places;  ///< empty: no body at this time
    std::vector<HeardPair> pairs;
    std::vector<int> quiet_sources{};  ///< no pulse of them just now, or not yet
    int pair_count = 0;
    bool has_ghost = false;
    std::vector<BonePlace> ghost_bones{};
    /// Over the head of every person, where there are several.
    struct Tag {
        int performer = 0;
        Vector3d p_m;
    };
    std::vector<Tag> tags{};
    Eigen::AlignedBox3d others;  ///< the bodies of the other people; empty: nobody else
    /// Of the two hands, or wrists, that the plot shows: of all pairs they come nearest in the take.
    struct Distance {
        Vector3d middle_m;
        double distance_m = 0;
        std::optional<double> sigma_m;
        int one = 0, other = 1;  ///< performers
        std::string joint, other_joint;
    };
    std::optional<Distance> distance{};
    SceneSubject subject = SceneSubject::kShown;

    bool hasBody() const { return !places.joints.p_world_joint.empty(); }
    int goodPairs() const;
    std::vector<Vector3d> boardPoints() const;
    std::vector<Vector3d> sourcePoints() const;
};

class TakeScene {
public:
    explicit TakeScene(ReviewContext& review) : review_(review) {}

    void setSubject(SceneSubject subject) { subject_ = subject; }

    /// Asks the document for the parts that the layers need.
    ComposedScene compose(const SceneLayers& layers);

private:
    /// A motion with the body that fits it.
    struct Track {
        std::shared_ptr<const TimedMotion> motion;
        int64_t max_gap_ns = 0;
        std::shared_ptr<const std::vector<FootContacts>> contacts;
        FeetAtRest feet;
        FittedBody body;

        /// `when_feet_stood` may come later, or never.
        void follow(std::shared_ptr<const TimedMotion> of,
                    std::shared_ptr<const std::vector<FootContacts>> when_feet_stood);
        std::optional<Pose> at(double t_s) const;
    };
    void addPairs(ComposedScene& composed, double t_s);
    void addTrails(ComposedScene& composed, const SceneColors& colors, double t_s);
    void addContacts(ComposedScene& composed, const SceneColors& colors, double t_s);
    void addDistance(ComposedScene& composed, int other, const Skeleton& skeleton, const BodyPlaces& places,
                     double t_s);
    void placeAnchors(ComposedScene& composed, const Pose& pose);
    /// The other people of the take; of their suits only the sources that are listened to.
    void addOthers(ComposedScene& composed, const SceneLayers& layers, const SceneColors& colors, double t_s);
    void addCompared(ComposedScene& composed, const SceneColors& colors, double t_s);

    ReviewContext& review_;
    SceneSubject subject_ = SceneSubject::kShown;
    Track shown_, compared_;
    std::vector<Track> others_;  ///< by subject; the shown one's stays empty
};

}  // namespace noctule::ui
