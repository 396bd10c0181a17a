// SPDX-License-Identifier: Apache-2.0
// The motion of an FBX file: one stack, one layer, and per joint a curve for every number that changes.
#include <array>

#include "core/formats/fbx_scene.h"

namespace noctule {
namespace {

constexpr int32_t kLinearKeys = 4;

struct Curve {
    const char* channel;  ///< "d|X"
    std::vector<float> values;
};

class AnimationWriter {
public:
    AnimationWriter(FbxScene& scene, const Figure& figure, const FbxOptions& options, int64_t layer)
        : scene_(scene), figure_(figure), options_(options), layer_(layer) {
        for (size_t f = 0; f < figure.clip.frames.size(); ++f)
            times_.push_back(fbxTime(figure.clip, f));
        if (layer != 0)
            return;
        const auto time = [](const char* name, int64_t value) {
            return fbxProperty(name, "KTime", "Time", "", value);
        };
        const int64_t stack =
            scene.add("AnimationStack", figure.clip.name, "AnimStack", "",
                      {fbxProperties({time("LocalStart", 0), time("LocalStop", times_.back()),
                                      time("ReferenceStart", 0), time("ReferenceStop", times_.back())})});
        layer_ = scene.add("AnimationLayer", "BaseLayer", "AnimLayer", "", {fbxProperties({})});
        scene.connect(layer_, stack);
    }

    int64_t layer() const { return layer_; }

    void addJoint(size_t joint, int64_t model) {
        addCurves("Lcl Rotation", "R", model, rotation(joint));
        if (jointIsMoved(figure_.clip, joint))
            addCurves("Lcl Translation", "T", model, translation(joint));
        if (figure_.confidence.empty())
            return;
        Curve curve{"d|confidence", {}};
        for (const std::vector<float>& row : figure_.confidence)
            curve.values.push_back(row[joint]);
        addCurves("confidence", "confidence", model, {curve});
    }

private:
    std::vector<Curve> rotation(size_t joint) const {
        std::vector<Curve> curves{{"d|X", {}}, {"d|Y", {}}, {"d|Z", {}}};
        Vector3d angles_rad = Vector3d::Zero();
        for (const Pose& pose : figure_.clip.frames) {
            angles_rad = eulerFromRotation(kFbxOrder, pose.q_parent_joint[joint], angles_rad);
            for (size_t i = 0; i < 3; ++i)
                curves[static_cast<size_t>(kFbxOrder[i])].values.push_back(
                    static_cast<float>(degrees(angles_rad[static_cast<int>(i)])));
        }
        return curves;
    }

    std::vector<Curve> translation(size_t joint) const {
        std::vector<Curve> curves{{"d|X", {}}, {"d|Y", {}}, {"d|Z", {}}};
        for (size_t f = 0; f < times_.size(); ++f) {
            const Vector3d p = localPosition_m(figure_.clip, f, joint) / options_.metres_per_unit;
            for (int axis = 0; axis < 3; ++axis)
                curves[static_cast<size_t>(axis)].values.push_back(static_cast<float>(p[axis]));
        }
        return curves;
    }

    void addCurves(const std::string& property, const std::string& name, int64_t model,
                   const std::vector<Curve>& curves) {
        std::vector<FbxNode> defaults;
        for (const Curve& curve : curves)
            defaults.push_back(
                fbxProperty(curve.channel, "Number", "", "A", static_cast<double>(curve.values.front())));
        const int64_t node =
            scene_.add("AnimationCurveNode", name, "AnimCurveNode", "", {fbxProperties(defaults)});
        scene_.connect(node, layer_);
        scene_.connect(node, model, property);
        for (const Curve& curve : curves)
            scene_.connect(addCurve(curve), node, curve.channel);
    }

    /// One set of flags serves all keys.
    int64_t addCurve(const Curve& curve) {
        return scene_.add(
            "AnimationCurve", "", "AnimCurve", "",
            {FbxNode("Default", static_cast<double>(curve.values.front())), FbxNode("KeyVer", int32_t{4008}),
             FbxNode("KeyTime", times_), FbxNode("KeyValueFloat", curve.values),
             FbxNode("KeyAttrFlags", std::vector<int32_t>{kLinearKeys}),
             FbxNode("KeyAttrDataFloat", std::vector<float>(4, 0.0F)),
             FbxNode("KeyAttrRefCount", std::vector<int32_t>{static_cast<int32_t>(times_.size())})});
    }

    FbxScene& scene_;
    const Figure& figure_;
    const FbxOptions& options_;
    std::vector<int64_t> times_;
    int64_t layer_;
};

}  // namespace

int64_t addFbxAnimation(FbxScene& scene, const Figure& figure, const FbxOptions& options,
                        const std::vector<int64_t>& models, int64_t layer) {
    if (figure.clip.frames.empty())
        return layer;
    AnimationWriter writer(scene, figure, options, layer);
    for (size_t j = 0; j + 1 < models.size(); ++j)
        writer.addJoint(j, models[j + 1]);
    return writer.layer();
}

}  // namespace noctule
