// SPDX-License-Identifier: Apache-2.0
// Bones by the shape of their tree: a body that stands upright has two ends at its feet, two far to the sides
// and one on top; where the chains from these ends meet are hips and chest.
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/mesh/rig/bone_map.h"
#include "core/mesh/rig/rig_tree.h"

namespace noctule {
namespace {

class BodyShape {
public:
    explicit BodyShape(const RiggedMesh& mesh) : mesh_(mesh), children_(childrenOf(mesh)) {
        const std::vector<bool> moves = movesSkin(mesh);
        for (size_t n = 0; n < mesh.nodes.size(); ++n)
            counts_.push_back(mesh.isRigged() ? moves[n] : true);
        for (size_t n = 0; n < mesh.nodes.size(); ++n)
            if (counts_[n])
                box_.extend(place(static_cast<int>(n)));
    }

    BoneMap map() {
        if (box_.isEmpty() || !findLegs() || !findArms())
            return {};
        name("Hips", hips_);
        mapTrunk();
        mapLimb(left_leg_, "Left", {"", "UpLeg", "Leg", "Foot", "ToeBase"});
        mapLimb(right_leg_, "Right", {"", "UpLeg", "Leg", "Foot", "ToeBase"});
        mapLimb(left_arm_, "Left", {"Shoulder", "Arm", "ForeArm", "Hand", ""});
        mapLimb(right_arm_, "Right", {"Shoulder", "Arm", "ForeArm", "Hand", ""});
        return map_;
    }

private:
    using Chain = std::vector<int>;

    Vector3d place(int node) const {
        return mesh_.nodes[static_cast<size_t>(node)].T_world_rest.translation();
    }
    void name(const std::string& joint, int node) {
        map_.node_of_joint[joint] = mesh_.nodes[static_cast<size_t>(node)].name;
    }

    /// Nodes below which no other moves the skin.
    std::vector<int> ends() const {
        std::vector<int> ends;
        for (size_t n = 0; n < mesh_.nodes.size(); ++n)
            if (counts_[n] && std::none_of(children_[n].begin(), children_[n].end(),
                                           [&](int child) { return counts_[static_cast<size_t>(child)]; }))
                ends.push_back(static_cast<int>(n));
        return ends;
    }

    /// The lowest end and the lowest on the other side of the middle.
    bool findLegs() {
        const double low = box_.min().y() + 0.2 * box_.sizes().y();
        std::vector<int> feet = ends();
        std::erase_if(feet, [&](int node) { return place(node).y() > low; });
        int left = -1, right = -1;
        for (const int node : feet)
            for (int& side : {std::ref(left), std::ref(right)}) {
                const bool belongs = (place(node).x() > box_.center().x()) == (&side == &left);
                if (belongs && (side < 0 || depth(node) > depth(side)))
                    side = node;
            }
        if (left < 0 || right < 0)
            return false;
        hips_ = commonAncestor(mesh_, left, right);
        left_leg_ = chainBelow(mesh_, hips_, left);
        right_leg_ = chainBelow(mesh_, hips_, right);
        return hips_ >= 0 && limb(left_leg_) && limb(right_leg_);
    }

    /// The ends farthest to both sides, above the knees.
    bool findArms() {
        int left = -1, right = -1;
        for (const int node : ends()) {
            if (place(node).y() < box_.min().y() + 0.25 * box_.sizes().y() || !hangsOn(mesh_, node, hips_))
                continue;
            if (left < 0 || place(node).x() > place(left).x())
                left = node;
            if (right < 0 || place(node).x() < place(right).x())
                right = node;
        }
        if (left < 0 || left == right)
            return false;
        chest_ = commonAncestor(mesh_, left, right);
        left_arm_ = upToFingers(chainBelow(mesh_, chest_, left));
        right_arm_ = upToFingers(chainBelow(mesh_, chest_, right));
        return limb(left_arm_) && limb(right_arm_);
    }

    int depth(int node) const { return static_cast<int>(chainBelow(mesh_, -1, node).size()); }

    /// The hand is where fingers part.
    Chain upToFingers(Chain chain) const {
        for (size_t i = 2; i < chain.size(); ++i)
            if (children_[static_cast<size_t>(chain[i])].size() > 2)
                chain.resize(i + 1);
        return chain;
    }

    struct Limb {
        size_t first, middle, last;
    };

    /// Three nodes with bones of about one length between them that make up most of the chain.
    static constexpr size_t kLongestChain = 48;  ///< of a body; what is longer is none
    std::optional<Limb> limb(const Chain& chain) const {
        std::optional<Limb> best;
        double least = 1e9, longest = 0;
        if (chain.size() > kLongestChain)
            return best;
        const auto length = [&](size_t a, size_t b) { return (place(chain[a]) - place(chain[b])).norm(); };
        for (size_t i = 0; i < chain.size(); ++i)
            for (size_t k = i + 2; k < chain.size(); ++k)
                longest = std::max(longest, length(i, k));
        for (size_t i = 0; i < chain.size(); ++i)
            for (size_t j = i + 1; j < chain.size(); ++j)
                for (size_t k = j + 1; k < chain.size(); ++k) {
                    const double unlike = std::abs(std::log(length(i, j) / length(j, k)));
                    if (length(i, j) + length(j, k) > 0.75 * longest && unlike < least) {
                        least = unlike;
                        best = {i, j, k};
                    }
                }
        return best;
    }

    /// Names: before the limb, its three joints, after it; an empty name is not given.
    void mapLimb(const Chain& chain, const std::string& side, const std::array<const char*, 5>& names) {
        const Limb found = *limb(chain);
        const auto give = [&](const char* joint, size_t index) {
            if (*joint)
                name(side + joint, chain[index]);
        };
        if (found.first > 0)
            give(names[0], found.first - 1);
        give(names[1], found.first);
        give(names[2], found.middle);
        give(names[3], found.last);
        if (found.last + 1 < chain.size())
            give(names[4], found.last + 1);
    }

    void mapTrunk() {
        const Chain trunk = chainBelow(mesh_, hips_, chest_);
        if (!trunk.empty())
            name("Spine", trunk.front());
        if (trunk.size() > 1)
            name("Chest", chest_);
        int top = -1;
        for (const int node : ends())
            if (hangsOn(mesh_, node, chest_) &&
                std::abs(place(node).x() - box_.center().x()) < 0.1 * box_.sizes().y())
                top = top < 0 || place(node).y() > place(top).y() ? node : top;
        const Chain neck = top < 0 ? Chain() : chainBelow(mesh_, chest_, top);
        if (!neck.empty())
            name("Head", neck[std::min<size_t>(1, neck.size() - 1)]);
        if (neck.size() > 1)
            name("Neck", neck.front());
    }

    const RiggedMesh& mesh_;
    std::vector<std::vector<int>> children_;
    std::vector<bool> counts_;
    Eigen::AlignedBox3d box_;
    int hips_ = -1, chest_ = -1;
    Chain left_leg_, right_leg_, left_arm_, right_arm_;
    BoneMap map_;
};

}  // namespace

BoneMap mapByShape(const RiggedMesh& mesh) {
    return BodyShape(mesh).map();
}

}  // namespace noctule
