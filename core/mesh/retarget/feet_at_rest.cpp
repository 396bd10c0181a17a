// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/retarget/feet_at_rest.h"

#include <algorithm>
#include <cmath>

#include "core/body/joint_names.h"
#include "core/math/conventions.h"

namespace noctule {
namespace {

constexpr double kMostShinTilt_rad = radians(45);  ///< beyond, the zero pose is no standing one
constexpr double kMostTilt_rad = radians(40);      ///< between what stands say and what the zero pose does
constexpr double kStep_s = 1.0 / 60;
constexpr size_t kLeastSamples = 6;  ///< of a stand
constexpr size_t kMostStands = 20;   ///< that are looked at

Vector3d upBesideShin(const Skeleton& skeleton, const std::string& side) {
    const int shin = findByAnyName(skeleton, side + "Leg"), foot = findByAnyName(skeleton, side + "Foot");
    if (shin < 0 || foot < 0)
        return Vector3d::UnitY();
    const GlobalPose zero = globalPose(skeleton, skeleton.zeroPose());
    const Vector3d up =
        zero.p_world_joint[static_cast<size_t>(shin)] - zero.p_world_joint[static_cast<size_t>(foot)];
    const Vector3d across(up.x(), up.y(), 0);
    return across.y() > std::cos(kMostShinTilt_rad) * across.norm() ? Vector3d(across.normalized())
                                                                    : Vector3d(Vector3d::UnitY());
}

/// A foot at one instant of a stand.
struct FootSample {
    Vector3d p_ankle_m, up;  ///< `up`: the world's, in the foot's frame
    double speed = 0;        ///< of the ankle, in any unit
};

/// What a stand says of its foot at its calmest.
struct FlatFoot {
    Vector3d up;
    double heel_m = 0;  ///< height of the ankle above the toes: least where the sole is flat
};

class FootReader {
public:
    FootReader(const Skeleton& skeleton, const std::string& side)
        : skeleton_(skeleton),
          foot_(findByAnyName(skeleton, side + "Foot")),
          usual_up_(upBesideShin(skeleton, side)) {
        const int toes = findByAnyName(skeleton, side + "ToeBase");
        if (toes >= 0)
            p_toes_m_ = skeleton.joint(toes).offset_m;
        else if (foot_ >= 0)
            p_toes_m_ = skeleton.joint(foot_).end_m.value_or(Vector3d::UnitZ());
    }

    Vector3d up(const std::vector<FootPlant>& plants,
                const std::function<std::optional<Pose>(double t_s)>& pose) const {
        std::vector<FlatFoot> flat;
        const size_t every = plants.size() / kMostStands + 1;
        for (size_t i = 0; foot_ >= 0 && i < plants.size(); i += every)
            if (const auto seen = flattest(plants[i], pose))
                flat.push_back(*seen);
        if (flat.empty())
            return usual_up_;
        // On tiptoe nothing is flat.
        std::ranges::sort(flat, {}, &FlatFoot::heel_m);
        flat.resize((flat.size() + 1) / 2);
        Vector3d middle;
        for (int axis = 0; axis < 3; ++axis) {
            const auto half = flat.begin() + static_cast<std::ptrdiff_t>(flat.size() / 2);
            std::ranges::nth_element(flat, half, {}, [&](const FlatFoot& f) { return f.up[axis]; });
            middle[axis] = half->up[axis];
        }
        return middle.normalized();
    }

private:
    std::optional<FlatFoot> flattest(const FootPlant& plant,
                                     const std::function<std::optional<Pose>(double t_s)>& pose) const {
        std::vector<FootSample> samples;
        for (double t_s = plant.from_s; t_s <= plant.to_s; t_s += kStep_s)
            if (const auto at = pose(t_s)) {
                const GlobalPose global = globalPose(skeleton_, *at);
                const auto foot = static_cast<size_t>(foot_);
                samples.push_back(
                    {global.p_world_joint[foot], global.q_world_joint[foot].conjugate() * Vector3d::UnitY()});
            }
        if (samples.size() < kLeastSamples)
            return std::nullopt;
        samples.front().speed = samples.back().speed = 1e9;
        for (size_t i = 1; i + 1 < samples.size(); ++i)
            samples[i].speed = (samples[i + 1].p_ankle_m - samples[i - 1].p_ankle_m).norm();
        std::ranges::sort(samples, {}, &FootSample::speed);
        Vector3d sum = Vector3d::Zero();
        for (size_t i = 0; i < samples.size() / 3; ++i)
            sum += samples[i].up;
        const Vector3d up = sum.normalized();
        if (!(up.dot(usual_up_) > std::cos(kMostTilt_rad)))
            return std::nullopt;
        return FlatFoot{up, -up.dot(p_toes_m_)};
    }

    const Skeleton& skeleton_;
    int foot_;
    Vector3d usual_up_, p_toes_m_ = Vector3d::UnitZ();
};

}  // namespace

FeetAtRest feetAtRest(const Skeleton& skeleton) {
    return {{upBesideShin(skeleton, "Left"), upBesideShin(skeleton, "Right")}};
}

FeetAtRest feetAtRest(const Skeleton& skeleton, const FootPlants& plants,
                      const std::function<std::optional<Pose>(double t_s)>& pose) {
    return {{FootReader(skeleton, "Left").up(plants[0], pose),
             FootReader(skeleton, "Right").up(plants[1], pose)}};
}

}  // namespace noctule
