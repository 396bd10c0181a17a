// SPDX-License-Identifier: Apache-2.0
// The objects of an FBX file and how they hang together, as they are collected: every object has a number,
// and a connection makes one belong to another (or to one property of it). The writer's parts fill it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/formats/fbx_node.h"
#include "core/formats/figure.h"
#include "core/math/euler.h"

namespace noctule {

class FbxScene {
public:
    static constexpr int64_t kTop = 0;  ///< the scene itself

    /// A new object of a kind ("Model"), class ("Model", "SubDeformer") and type ("LimbNode"); its number.
    int64_t add(const std::string& kind, const std::string& name, const std::string& of_class,
                const std::string& type, const std::vector<FbxNode>& content);
    void connect(int64_t child, int64_t parent);
    void connect(int64_t child, int64_t parent, const std::string& property);

    FbxNode definitions() const;
    /// Out of the scene, which is used up then.
    FbxNode takeObjects() { return std::move(objects_); }
    FbxNode takeConnections() { return std::move(connections_); }

private:
    FbxNode objects_{"Objects"}, connections_{"Connections"};
    std::map<std::string, int32_t> counts_;
    int64_t next_ = 1'000'000;
};

/// One entry of a list of named values ("Lcl Translation", type, label, flags, then the values).
template <class... Values>
FbxNode fbxProperty(const std::string& name, const std::string& type, const std::string& label,
                    const std::string& flags, const Values&... values) {
    return FbxNode("P", name, type, label, flags, values...);
}
FbxNode fbxProperties(const std::vector<FbxNode>& entries);

/// FBX turns about x, then y, then z of the parent: Rz Ry Rx, which we write from the outside in.
inline constexpr EulerOrder kFbxOrder = kEulerZYX;

/// 46 186 158 000 to the second, an exact number at all usual frame rates.
int64_t fbxTime(double seconds);
/// The instant of a frame; the last one for "how long".
int64_t fbxTime(const MotionClip& clip, size_t frame);
int64_t fbxLastTime(const MotionClip& clip);

struct FbxOptions {
    double metres_per_unit = 0.01;  ///< 0.01 as everybody expects; the file states it
    /// The node above the joints. It is no bone: Blender would let the hips hang on its end and not move.
    std::string root_name = "Reference";
};

/// The joints as models: first what stands above them, then one per joint of the figure, in its order.
std::vector<int64_t> addFbxSkeleton(FbxScene& scene, const Figure& figure, const FbxOptions& options);
/// Mesh, skin and bind pose; nothing without a body. `models` as from addFbxSkeleton.
void addFbxBody(FbxScene& scene, const Figure& figure, const FbxOptions& options,
                const std::vector<int64_t>& models);
/// Into the layer, or with 0 into one of a new stack with the clip's name; the layer. Nothing without frames.
int64_t addFbxAnimation(FbxScene& scene, const Figure& figure, const FbxOptions& options,
                        const std::vector<int64_t>& models, int64_t layer = 0);

}  // namespace noctule
