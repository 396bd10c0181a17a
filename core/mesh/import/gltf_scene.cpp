// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/import/gltf_scene.h"

namespace noctule {
namespace {

/// The tree; several roots hang on one more.
std::vector<aiNode*> buildTree(const GltfNodes& nodes, aiScene& scene) {
    std::vector<aiNode*> made;
    for (size_t n = 0; n < nodes.names.size(); ++n) {
        made.push_back(new aiNode(nodes.names[n]));
        made.back()->mTransformation = gltfMatrix(nodes.T_parent_node[n]);
    }
    std::vector<aiNode*> roots;
    for (const int node : nodes.order) {
        std::vector<aiNode*> children;
        for (const int child : nodes.children[static_cast<size_t>(node)])
            children.push_back(made[static_cast<size_t>(child)]);
        if (!children.empty())
            made[static_cast<size_t>(node)]->addChildren(static_cast<unsigned>(children.size()),
                                                         children.data());
        if (nodes.parents[static_cast<size_t>(node)] < 0)
            roots.push_back(made[static_cast<size_t>(node)]);
    }
    scene.mRootNode = roots.size() == 1 ? roots.front() : new aiNode("ROOT");
    if (roots.size() > 1)
        scene.mRootNode->addChildren(static_cast<unsigned>(roots.size()), roots.data());
    return made;
}

}  // namespace

aiMatrix4x4 gltfMatrix(const Eigen::Affine3d& T) {
    const Eigen::Matrix4f m = T.matrix().cast<float>();
    return {m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2), m(1, 3),
            m(2, 0), m(2, 1), m(2, 2), m(2, 3), 0,       0,       0,       1};
}

Result<GltfScene> gltfScene(const GltfDocument& document, const std::string& path) {
    const auto nodes = gltfNodes(document);
    if (!nodes)
        return nodes.error();
    GltfScene made;
    made.scene = std::make_unique<aiScene>();
    addGltfLooks(document, *made.scene);
    const std::vector<aiNode*> ai_nodes = buildTree(*nodes, *made.scene);
    if (const Status added = addGltfMeshes(document, *nodes, path, ai_nodes, made); !added)
        return added.error();
    if (const Status added = addGltfClips(document, *nodes, *made.scene); !added)
        return added.error();
    made.humanoid = gltfHumanoid(document, *nodes);
    return made;
}

}  // namespace noctule
