// SPDX-License-Identifier: Apache-2.0
// Lengths as shares of the height are those of the default actor (body/default_actor.cpp).
#include "core/mesh/rig/body_landmarks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "core/body/actor.h"
#include "core/math/json.h"
#include "core/mesh/skinned_mesh.h"
#include "core/mesh/surface_graph.h"

namespace noctule {
namespace {

/// "LeftHandEnd" -> "LeftHand"
std::string jointOfTip(const std::string& tip) {
    return tip.substr(0, tip.size() - std::string_view("End").size());
}

constexpr double kAdult_m = 1.75;  ///< the height that lengths below belong to

class LandmarkFinder {
public:
    LandmarkFinder(const TriangleMesh& figure, const std::string& where) : where_(where) {
        const std::vector<int> pieces = piecesOf(figure);
        figure_.points = figure.points;
        for (const auto& triangle : figure.triangles)
            if (pieces[triangle[0]] == 0)
                figure_.triangles.push_back(triangle);
        for (size_t p = 0; p < figure.points.size(); ++p) {
            if (pieces[p] == 0)
                box_.extend(figure.points[p]);
            is_body_.push_back(pieces[p] == 0);
            height_.push_back(figure.points[p].y());
        }
    }

    Result<Landmarks> find() {
        if (box_.isEmpty() || !(box_.sizes().y() > 1e-3) || box_.sizes().z() > box_.sizes().y())
            return trouble("the figure does not stand upright");
        low_ = box_.min().y();
        tall_ = box_.sizes().y();
        for (const auto step : {&LandmarkFinder::findLegs, &LandmarkFinder::findArms})
            if (const Status found = (this->*step)(); !found)
                return found.error();
        findTrunk();
        findHead();
        findShoulders();
        return places_;
    }

private:
    Error trouble(const std::string& what) const {
        return {
            ErrorKind::kUnusable, where_ + ": " + what,
            "Use a figure that stands upright with its arms away from its body, or set the joints by hand"};
    }
    double adult(double metres) const { return metres / kAdult_m * tall_; }
    static double sign(const std::string& side) { return side == "Left" ? 1 : -1; }
    double middle() const { return box_.center().x(); }

    /// Points of the body that qualify, the one for which `more` is largest.
    template <class Where, class More>
    std::optional<uint32_t> most(Where where, More more) const {
        std::optional<uint32_t> best;
        for (uint32_t p = 0; p < figure_.points.size(); ++p)
            if (is_body_[p] && where(figure_.points[p]) &&
                (!best || more(figure_.points[p]) > more(figure_.points[*best])))
                best = p;
        return best;
    }

    /// The outermost ring of a height around an expected x, else the one beside it.
    std::optional<Ring> slice(double y, double near_x) const {
        const auto beside = [&](const Ring& ring) {
            return std::max({0.0, ring.box.min().x() - near_x, near_x - ring.box.max().x()});
        };
        std::optional<Ring> best;
        for (const Ring& ring : ringsAt(figure_, height_, y)) {
            if (ring.length < 0.04 * tall_)
                continue;
            const double nearer = best ? beside(*best) - beside(ring) : 1;
            if (nearer > 0 || (nearer == 0 && ring.length > best->length))
                best = ring;
        }
        return best;
    }

    /// How high the two legs are apart: the height at which slices come together.
    std::optional<double> crotch() const {
        for (double y = 0.2; y < 0.65; y += 0.005) {
            const auto ring = slice(low_ + y * tall_, middle());
            if (ring && ring->box.min().x() < middle() && ring->box.max().x() > middle() &&
                ring->box.sizes().x() > 0.1 * tall_)
                return low_ + y * tall_;
        }
        return std::nullopt;
    }

    Status findLegs() {
        const auto crotch_y = crotch();
        if (!crotch_y)
            return trouble("no two legs were found");
        const double hip_y = *crotch_y + adult(0.075);
        for (const std::string side : {"Left", "Right"}) {
            const auto thigh = slice(*crotch_y - adult(0.05), middle() + sign(side) * adult(0.12));
            const double knee_y = low_ + 0.525 * (hip_y - low_), ankle_y = low_ + 0.085 * (hip_y - low_);
            if (!thigh)
                return trouble("no thigh was found");
            const auto knee = slice(knee_y, thigh->centre.x());
            const auto ankle = knee ? slice(ankle_y, knee->centre.x()) : std::nullopt;
            if (!ankle)
                return trouble("no ankle was found");
            const Vector3d along = thigh->centre - knee->centre;
            const Vector3d hip = thigh->centre + along * ((hip_y - thigh->centre.y()) / along.y()) -
                                 sign(side) * Vector3d(adult(0.01), 0, 0);
            places_[side + "UpLeg"] = hip;
            places_[side + "Leg"] = {knee->centre.x(), knee_y, knee->centre.z()};
            places_[side + "Foot"] = {ankle->centre.x(), ankle_y, ankle->centre.z()};
            findToes(side);
        }
        return Done{};
    }

    void findToes(const std::string& side) {
        const Vector3d ankle = places_[side + "Foot"];
        const auto of_foot = [&](const Vector3d& p) {
            return p.y() < ankle.y() && std::abs(p.x() - ankle.x()) < adult(0.12);
        };
        const auto toe = most(of_foot, [](const Vector3d& p) { return p.z(); });
        const auto heel = most(of_foot, [](const Vector3d& p) { return -p.z(); });
        const Vector3d tip = toe ? figure_.points[*toe] : ankle + Vector3d(0, 0, adult(0.19));
        const double back_z = heel ? figure_.points[*heel].z() : ankle.z();
        const double low = low_ + adult(0.02);
        const Vector3d ball = ankle + (tip - ankle) * std::clamp((0.7 * tip.z() + 0.3 * back_z - ankle.z()) /
                                                                     std::max(1e-6, tip.z() - ankle.z()),
                                                                 0.3, 0.9);
        places_[side + "ToeBase"] = {ball.x(), low, ball.z()};
        places_[side + "ToeBaseEnd"] = {tip.x(), low, tip.z()};
    }

    /// Rings around the arm at equal steps from the fingertip on.
    struct Arm {
        std::vector<Ring> rings;
        double step = 0;
        Vector3d at(double way) const {
            const double index = std::clamp(way / step - 1, 0.0, static_cast<double>(rings.size() - 1));
            const auto i = std::min(static_cast<size_t>(index), rings.size() - 2);
            const double f = index - static_cast<double>(i);
            return (1 - f) * rings[i].centre + f * rings[i + 1].centre;
        }
    };

    Arm armFrom(uint32_t fingertip) const {
        const std::vector<double> way = waysFrom(figure_, fingertip);
        Arm arm;
        arm.step = 0.01 * tall_;
        for (int i = 1; i < 60; ++i) {
            Ring all;
            for (const Ring& ring : ringsAt(figure_, way, i * arm.step)) {
                all.centre += ring.length * ring.centre;
                all.length += ring.length;
            }
            if (!(all.length > 0))
                break;
            all.centre /= all.length;
            arm.rings.push_back(all);
        }
        return arm;
    }

    /// How far from the fingertip the arm becomes the trunk: where rings grow far beyond those of the arm.
    static std::optional<size_t> armpit(const Arm& arm) {
        for (size_t i = 28; i < arm.rings.size(); ++i)
            if (arm.rings[i].length > 1.45 * arm.rings[i - 8].length)
                return i;
        return std::nullopt;
    }

    Status findArms() {
        for (const std::string side : {"Left", "Right"}) {
            const auto tip = most([&](const Vector3d& p) { return p.y() > low_ + 0.3 * tall_; },
                                  [&](const Vector3d& p) { return sign(side) * p.x(); });
            const Arm arm = tip ? armFrom(*tip) : Arm();
            const auto end = arm.rings.size() > 30 ? armpit(arm) : std::nullopt;
            if (!end)
                return trouble("no arm was found on the " + std::string(side == "Left" ? "left" : "right"));
            const double length = arm.step * static_cast<double>(*end) + adult(0.01);
            places_[side + "HandEnd"] = figure_.points[*tip];
            places_[side + "Hand"] = arm.at(wristAt(arm, length));
            places_[side + "ForeArm"] = arm.at(0.60 * length);
            // The rings lean towards the trunk near the shoulder: go on straight from the upper arm.
            const Vector3d elbow = places_[side + "ForeArm"], upper = arm.at(0.82 * length);
            places_[side + "Arm"] = elbow + (upper - elbow).normalized() * (0.40 * length);
        }
        return Done{};
    }

    /// The narrowest place where a wrist may be.
    static double wristAt(const Arm& arm, double length) {
        const auto first = static_cast<size_t>(0.2 * length / arm.step),
                   last = static_cast<size_t>(0.32 * length / arm.step);
        const auto narrowest =
            std::min_element(arm.rings.begin() + static_cast<std::ptrdiff_t>(first),
                             arm.rings.begin() + static_cast<std::ptrdiff_t>(last),
                             [](const Ring& a, const Ring& b) { return a.length < b.length; });
        return arm.step * static_cast<double>(narrowest - arm.rings.begin() + 1);
    }

    /// A place inside the trunk or neck, a little nearer to the back, as the spine is.
    Vector3d inTrunk(double y) const {
        const auto ring = slice(y, middle());
        return {middle(), y, ring ? ring->box.min().z() + 0.4 * ring->box.sizes().z() : box_.center().z()};
    }

    /// The narrowest slice between shoulders and crown; the head turns on it.
    double neckHeight() const {
        const double from = std::max(places_.at("LeftArm").y(), places_.at("RightArm").y()) + adult(0.03);
        double best_y = low_ + 0.85 * tall_, best = 1e9;
        for (double y = from; y < low_ + 0.92 * tall_; y += 0.005 * tall_)
            if (const auto ring = slice(y, middle()); ring && ring->length < best) {
                best = ring->length;
                best_y = y;
            }
        return best_y;
    }

    void findTrunk() {
        const Vector3d hips = 0.5 * (places_["LeftUpLeg"] + places_["RightUpLeg"]);
        const double neck_y = neckHeight() - adult(0.06), hips_y = hips.y() + adult(0.05);
        const auto between = [&](double share) { return inTrunk(hips_y + share * (neck_y - hips_y)); };
        places_["Hips"] = inTrunk(hips_y);
        places_["Spine"] = between(0.06 / 0.44);
        places_["Chest"] = between(0.18 / 0.44);
        places_["Neck"] = inTrunk(neck_y);
    }

    void findHead() {
        places_["Head"] = inTrunk(neckHeight() + adult(0.02));
        places_["HeadEnd"] = {middle(), low_ + tall_, places_["Head"].z()};
    }

    void findShoulders() {
        for (const std::string side : {"Left", "Right"})
            places_[side + "Shoulder"] = {
                middle() + sign(side) * adult(0.02),
                std::min(places_["Neck"].y() - adult(0.01), places_[side + "Arm"].y() + adult(0.02)),
                0.5 * (places_["Neck"].z() + places_[side + "Arm"].z())};
    }

    std::string where_;
    TriangleMesh figure_;
    std::vector<bool> is_body_;
    std::vector<double> height_;
    Eigen::AlignedBox3d box_;
    double low_ = 0, tall_ = 1;
    Landmarks places_;
};

}  // namespace

std::vector<std::string> landmarkNames() {
    std::vector<std::string> names = canonicalJointNames();
    names.insert(names.end(),
                 {"HeadEnd", "LeftHandEnd", "RightHandEnd", "LeftToeBaseEnd", "RightToeBaseEnd"});
    return names;
}

std::vector<std::pair<std::string, std::string>> landmarkBones() {
    const Skeleton skeleton = defaultActor().skeleton;
    std::vector<std::pair<std::string, std::string>> bones;
    for (const std::string& name : landmarkNames()) {
        const int joint = skeleton.find(name);
        if (joint < 0)
            bones.emplace_back(jointOfTip(name), name);
        else if (const int parent = skeleton.joint(joint).parent; parent >= 0)
            bones.emplace_back(skeleton.joint(parent).name, name);
    }
    return bones;
}

Result<Landmarks> findLandmarks(const TriangleMesh& figure, const std::string& where) {
    return LandmarkFinder(figure, where).find();
}

Landmarks typicalLandmarks(double height_m) {
    const Actor actor = defaultActor();
    const Skeleton& skeleton = actor.skeleton;
    const GlobalPose pose = globalPose(skeleton, bindPose(skeleton));
    const double scale = height_m / actor.height_m;
    Landmarks landmarks;
    for (const std::string& name : landmarkNames()) {
        const bool is_tip = skeleton.find(name) < 0;
        const int joint = skeleton.find(is_tip ? jointOfTip(name) : name);
        const auto index = static_cast<size_t>(joint);
        const Vector3d tip_m = is_tip ? skeleton.joint(joint).end_m.value() : Vector3d::Zero();
        landmarks[name] = scale * (pose.p_world_joint[index] + pose.q_world_joint[index] * tip_m);
    }
    return landmarks;
}

std::string otherSideOf(const std::string& landmark) {
    if (landmark.starts_with("Left"))
        return "Right" + landmark.substr(4);
    return landmark.starts_with("Right") ? "Left" + landmark.substr(5) : std::string();
}

void putLandmark(Landmarks& landmarks, const std::string& name, const Vector3d& p_m, bool both_sides_alike) {
    const double middle_m = landmarks.at("Hips").x();
    Vector3d& place = landmarks.at(name);
    const std::string other = otherSideOf(name);
    const double x_m = both_sides_alike && other.empty() ? place.x() : p_m.x();
    place = {x_m, p_m.y(), p_m.z()};
    if (both_sides_alike && !other.empty())
        landmarks.at(other) = {2 * middle_m - p_m.x(), p_m.y(), p_m.z()};
}

nlohmann::json toJson(const Landmarks& landmarks) {
    nlohmann::json places = nlohmann::json::object();
    for (const auto& [name, p_m] : landmarks)
        places[name] = json::fromVector(p_m);
    return {{"format", "noctule-landmarks"}, {"version", 1}, {"places_m", places}};
}

Result<Landmarks> landmarksFromJson(const nlohmann::json& json, const std::string& where) {
    Landmarks landmarks;
    const auto places = json.is_object() ? json.find("places_m") : json.end();
    const bool ours = json::text(json, "format") == "noctule-landmarks" && json::number(json, "version") == 1;
    for (const std::string& name : landmarkNames()) {
        const auto p_m = ours && places != json.end() ? json::vector3(*places, name.c_str()) : std::nullopt;
        if (!p_m)
            return Error{ErrorKind::kUnreadable,
                         where + ": these are no landmarks of a body; " + name + " is missing",
                         "Choose a file that was saved as landmarks"};
        landmarks[name] = *p_m;
    }
    return landmarks;
}

}  // namespace noctule
