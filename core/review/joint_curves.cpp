// SPDX-License-Identifier: Apache-2.0
#include "core/review/joint_curves.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/motion/joint_angles.h"

namespace noctule {
namespace {

constexpr std::array<const char*, 3> kBallFreedoms{"z", "x", "y"};
constexpr std::array<const char*, 3> kRootPlaces{"left", "up", "forward"};
constexpr std::array<const char*, 3> kRootTurns{"yaw", "pitch", "roll"};

/// Value and sigma in SI; NaN: unknown.
struct Sample {
    double value = kNoValue, sigma = kNoValue;
};
/// Called for the frames that show something, in order: angles of the root and of balls follow on from the
/// ones before.
using Sampler = std::function<Sample(const TimedPose&)>;

int indexIn(const std::array<const char*, 3>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

int freedomOf(const Joint& joint, const std::string& name) {
    const auto found =
        std::find_if(joint.dof.begin(), joint.dof.end(), [&](const auto& dof) { return dof.name == name; });
    return found == joint.dof.end() ? -1 : static_cast<int>(found - joint.dof.begin());
}

std::optional<Vector3d> sigmaOf(const TimedPose& frame, size_t joint) {
    if (frame.sigma_rad.size() < 3 * (joint + 1))
        return std::nullopt;
    return Vector3d(frame.sigma_rad[3 * joint], frame.sigma_rad[3 * joint + 1],
                    frame.sigma_rad[3 * joint + 2]);
}

double nearestTurn(double angle_rad, double near_rad) {
    return angle_rad - 2 * std::numbers::pi * std::round((angle_rad - near_rad) / (2 * std::numbers::pi));
}

Sampler ballSampler(size_t joint, int component) {
    return [joint, component, near = Vector3d(0, 0, 0)](const TimedPose& frame) mutable {
        near = anglesZxyNear(frame.pose->q_parent_joint[joint], near);
        Sample sample{near[component], kNoValue};
        if (const auto sigma = sigmaOf(frame, joint))
            sample.sigma = sigmaZxy(near, *sigma)[component];
        return sample;
    };
}

/// The variances of a joint's angles from those of its right perturbation: variance k of the perturbation is
/// the sum over freedoms of (component k of the freedom's axis)^2 times its variance, solved backwards.
double freedomSigma(const Joint& joint, const Eigen::VectorXd& angles_rad, const Vector3d& sigma_rad,
                    int freedom) {
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> J_squared(3, angles_rad.size());
    for (int i = 0; i < angles_rad.size(); ++i) {
        Vector3d axis = joint.dof[static_cast<size_t>(i)].axis;
        if (joint.type == JointType::kUniversal && i == 0)  // the second turn comes after it
            axis = Eigen::AngleAxisd(-angles_rad[1], joint.dof[1].axis) * axis;
        J_squared.col(i) = axis.cwiseAbs2();
    }
    const auto variances = J_squared.colPivHouseholderQr().solve(sigma_rad.cwiseAbs2()).eval();
    return std::sqrt(std::max(0.0, variances[freedom]));
}

Sampler hingeSampler(const Joint& joint, size_t index, int freedom) {
    return [joint, index, freedom](const TimedPose& frame) {
        const JointAngles angles = projectOntoJoint(joint, frame.pose->q_parent_joint[index], false);
        Sample sample{nearestTurn(angles.angles_rad[freedom], 0), kNoValue};
        if (const auto sigma = sigmaOf(frame, index))
            sample.sigma = freedomSigma(joint, angles.angles_rad, *sigma, freedom);
        return sample;
    };
}

/// Yaw about the vertical first, then pitch, then roll: R = Ry Rx Rz.
Vector3d yawPitchRoll(const Quaterniond& q) {
    const Matrix3d r = q.normalized().toRotationMatrix();
    return {std::atan2(r(0, 2), r(2, 2)), std::asin(std::clamp(-r(1, 2), -1.0, 1.0)),
            std::atan2(r(1, 0), r(1, 1))};
}

Sampler rootTurnSampler(int component) {
    return [component, near = 0.0](const TimedPose& frame) mutable {
        near = nearestTurn(yawPitchRoll(frame.pose->q_parent_joint[0])[component], near);
        return Sample{near, kNoValue};
    };
}

Sampler rootPlaceSampler(int component) {
    return [component](const TimedPose& frame) {
        return Sample{frame.pose->p_world_root[component], kNoValue};
    };
}

Sampler samplerOf(const Skeleton& skeleton, const Skeleton& freedoms_of, const CurveChoice& choice,
                  CurveUnit& unit) {
    const int index = skeleton.find(choice.joint), described = freedoms_of.find(choice.joint);
    if (index < 0)
        return {};
    const Joint& joint = described < 0 ? skeleton.joint(index) : freedoms_of.joint(described);
    unit = CurveUnit::kDegrees;
    if (index == 0) {
        if (const int turn = indexIn(kRootTurns, choice.freedom); turn >= 0)
            return rootTurnSampler(turn);
        unit = CurveUnit::kMetres;
        const int place = indexIn(kRootPlaces, choice.freedom);
        return place >= 0 ? rootPlaceSampler(place) : Sampler{};
    }
    if (joint.type == JointType::kBall) {
        const int component = indexIn(kBallFreedoms, choice.freedom);
        return component >= 0 ? ballSampler(static_cast<size_t>(index), component) : Sampler{};
    }
    const int freedom = freedomOf(joint, choice.freedom);
    return freedom >= 0 ? hingeSampler(joint, static_cast<size_t>(index), freedom) : Sampler{};
}

}  // namespace

std::vector<CurveChoice> curveChoices(const Skeleton& skeleton) {
    std::vector<CurveChoice> choices;
    for (int j = 0; j < skeleton.size(); ++j) {
        const Joint& joint = skeleton.joint(j);
        const auto add = [&](const auto& freedoms) {
            for (const char* freedom : freedoms)
                choices.push_back({joint.name, freedom});
        };
        if (j == 0)
            add(kRootPlaces), add(kRootTurns);
        else if (joint.type == JointType::kBall)
            add(kBallFreedoms);
        else
            for (const DegreeOfFreedom& dof : joint.dof)
                choices.push_back({joint.name, dof.name});
    }
    return choices;
}

CurveChoice mainCurve(const Skeleton& skeleton, const std::string& joint) {
    const int index = skeleton.find(joint);
    if (index < 0)
        return {};
    if (index == 0)
        return {joint, "up"};
    const Joint& found = skeleton.joint(index);
    if (found.type == JointType::kBall)
        return {joint, "x"};  // forwards and backwards in the zero pose
    if (freedomOf(found, "flexion") >= 0)
        return {joint, "flexion"};
    return found.dof.empty() ? CurveChoice{} : CurveChoice{joint, found.dof.front().name};
}

MotionCurve motionCurve(const TimedMotion& motion, const CurveChoice& choice, const Skeleton* freedoms_of) {
    MotionCurve curve;
    const Sampler sample =
        samplerOf(motion.skeleton, freedoms_of ? *freedoms_of : motion.skeleton, choice, curve.unit);
    if (!sample)
        return curve;
    const double scale = curve.unit == CurveUnit::kDegrees ? 180 / std::numbers::pi : 1;
    std::vector<double> t_s;
    std::vector<float> value, low, high;
    bool has_sigma = false;
    const auto append = [&](double time_s, const Sample& at) {
        t_s.push_back(time_s);
        value.push_back(static_cast<float>(scale * at.value));
        low.push_back(static_cast<float>(scale * (at.value - 2 * at.sigma)));
        high.push_back(static_cast<float>(scale * (at.value + 2 * at.sigma)));
    };
    for (Sample before; const TimedPose& frame : motion.frames) {
        const Sample at = frame.pose && isUsable(*frame.pose) ? sample(frame) : Sample{};
        has_sigma = has_sigma || std::isfinite(at.sigma);
        const double time_s = static_cast<double>(frame.time_ns) * 1e-9;
        if (curve.unit == CurveUnit::kDegrees && std::abs(at.value - before.value) > std::numbers::pi)
            append(std::midpoint(t_s.back(), time_s), {});
        append(time_s, at);
        before = at;
    }
    if (has_sigma) {
        curve.low = SeriesPyramid(makeSeries(t_s, std::move(low)));
        curve.high = SeriesPyramid(makeSeries(t_s, std::move(high)));
    }
    curve.value = SeriesPyramid(makeSeries(std::move(t_s), std::move(value)));
    return curve;
}

}  // namespace noctule
