// SPDX-License-Identifier: Apache-2.0
#include "core/figure/joint_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/figure/facing.h"

namespace noctule::figure {
namespace {

using Chain = std::vector<int>;

class FigureShape {
public:
    FigureShape(const MotionClip& clip, const SeenMotion& seen)
        : skeleton_(clip.skeleton), children_(clip.skeleton.joints().size()) {
        const size_t count = children_.size();
        for (size_t j = 0; j < count; ++j) {
            const Joint& joint = skeleton_.joint(static_cast<int>(j));
            length_.push_back(joint.parent < 0 ? 0 : seen.distance(joint.parent, static_cast<int>(j)));
            reach_.push_back(joint.end_m ? joint.end_m->norm() : 0);
            if (joint.parent >= 0)
                children_[static_cast<size_t>(joint.parent)].push_back(static_cast<int>(j));
        }
        for (size_t j = count; j-- > 1;) {
            double& above = reach_[static_cast<size_t>(skeleton_.joint(static_cast<int>(j)).parent)];
            above = std::max(above, reach_[j] + length_[j]);
        }
    }

    JointMapping map() {
        if (!findLimbs())
            return {};
        mapLimb(legs_.a, "Left", {"", "UpLeg", "Leg", "Foot", "ToeBase"});
        mapLimb(legs_.b, "Right", {"", "UpLeg", "Leg", "Foot", "ToeBase"});
        mapLimb(arms_.a, "Left", {"Shoulder", "Arm", "ForeArm", "Hand", ""});
        mapLimb(arms_.b, "Right", {"Shoulder", "Arm", "ForeArm", "Hand", ""});
        mapHead();
        return std::move(mapping_);
    }

private:
    /// Two like branches of one joint.
    struct Pair {
        int top = -1;
        int a = -1, b = -1;
        double size = 0;
    };

    double branch(int joint) const { return reachOf(joint) + lengthOf(joint); }
    double reachOf(int joint) const { return reach_[static_cast<size_t>(joint)]; }
    double lengthOf(int joint) const { return length_[static_cast<size_t>(joint)]; }
    const std::vector<int>& childrenOf(int joint) const { return children_[static_cast<size_t>(joint)]; }

    /// As many joints, and bones of about the same lengths.
    bool alike(const Chain& a, const Chain& b) const {
        constexpr double kAlike = 0.2, kOfChain = 0.03;
        if (a.size() != b.size())
            return false;
        for (size_t i = 0; i < a.size(); ++i)
            if (std::abs(lengthOf(a[i]) - lengthOf(b[i])) >
                kAlike * std::max(lengthOf(a[i]), lengthOf(b[i])) + kOfChain * branch(a[0]))
                return false;
        return true;
    }

    std::vector<Pair> likeBranches() const {
        std::vector<Pair> pairs;
        for (int top = 0; top < skeleton_.size(); ++top)
            for (size_t i = 0; i < childrenOf(top).size(); ++i)
                for (size_t k = i + 1; k < childrenOf(top).size(); ++k) {
                    const int a = childrenOf(top)[i], b = childrenOf(top)[k];
                    if (const Chain left = longestChain(a); alike(left, longestChain(b)) && limb(left))
                        pairs.push_back({top, a, b, std::min(branch(a), branch(b))});
                }
        std::sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) { return x.size > y.size; });
        return pairs;
    }

    bool isBelow(int joint, int above) const {
        while (joint > above)
            joint = skeleton_.joint(joint).parent;
        return joint == above;
    }
    bool isBelow(int joint, const Pair& pair) const {
        return isBelow(joint, pair.a) || isBelow(joint, pair.b);
    }

    /// A branch besides the pair's that does not carry the other pair: neck and head.
    int headOf(const Pair& pair, const Pair& other) const {
        int best = -1;
        for (const int child : childrenOf(pair.top))
            if (child != pair.a && child != pair.b && !isBelow(other.top, child) && child != other.a &&
                child != other.b && (best < 0 || branch(child) > branch(best)))
                best = child;
        return best >= 0 && branch(best) > 0.05 * pair.size ? best : -1;
    }

    /// The two largest pairs of which neither is part of the other; the one with a head beside it is the
    /// arms.
    bool findLimbs() {
        const std::vector<Pair> pairs = likeBranches();
        for (size_t i = 0; i < pairs.size(); ++i)
            for (size_t k = i + 1; k < pairs.size(); ++k) {
                const Pair &x = pairs[i], &y = pairs[k];
                if (y.size < 0.4 * x.size || isBelow(y.top, x) || isBelow(x.top, y) || x.a == y.a ||
                    x.b == y.b || x.a == y.b || x.b == y.a)
                    continue;
                const bool x_has_head = headOf(x, y) >= 0, y_has_head = headOf(y, x) >= 0;
                if (x_has_head == y_has_head && x.top != y.top)
                    arms_ = isBelow(y.top, x.top) ? y : x;
                else
                    arms_ = y_has_head || x.top == y.top ? y : x;
                legs_ = arms_.a == x.a ? y : x;
                return true;
            }
        return false;
    }

    Chain longestChain(int joint) const {
        Chain chain{joint};
        while (!childrenOf(chain.back()).empty()) {
            const auto& below = childrenOf(chain.back());
            chain.push_back(*std::max_element(below.begin(), below.end(),
                                              [&](int a, int b) { return branch(a) < branch(b); }));
        }
        return chain;
    }

    struct Limb {
        size_t first, middle, last;
    };

    /// The three joints between which two long bones of about one length lie.
    std::optional<Limb> limb(const Chain& chain) const {
        constexpr size_t kLongest = 40;  // joints; what is longer is no limb
        std::optional<Limb> best;
        double most = 0;
        std::vector<double> along{0};
        for (size_t i = 1; i < chain.size(); ++i)
            along.push_back(along.back() + lengthOf(chain[i]));
        for (size_t i = 0; i < chain.size() && chain.size() <= kLongest; ++i)
            for (size_t j = i + 1; j < chain.size(); ++j)
                for (size_t k = j + 1; k < chain.size(); ++k) {
                    const double upper = along[j] - along[i], lower = along[k] - along[j];
                    const double score = upper + lower - 2 * std::abs(upper - lower);
                    if (score > most + 1e-9 * along.back()) {
                        most = score;
                        best = Limb{i, j, k};
                    }
                }
        return best && most > 0.35 * (along.back() + lengthOf(chain[0])) ? best : std::nullopt;
    }

    /// Names: before the limb, its three joints, after it; an empty name is not given.
    void mapLimb(int top, const std::string& side, const std::array<const char*, 5>& names) {
        const Chain chain = longestChain(top);
        const Limb found = *limb(chain);
        const auto give = [&](const char* joint, size_t index) {
            if (*joint)
                mapping_[side + joint] = chain[index];
        };
        if (found.first > 0)
            give(names[0], found.first - 1);
        give(names[1], found.first);
        give(names[2], found.middle);
        give(names[3], found.last);
        if (found.last + 1 < chain.size() && lengthOf(chain[found.last + 1]) > 0)
            give(names[4], found.last + 1);
    }

    /// The head is the joint of the neck's chain with the longest bone.
    void mapHead() {
        const int neck = headOf(arms_, legs_);
        if (neck < 0)
            return;
        const Chain chain = longestChain(neck);
        size_t head = std::min<size_t>(1, chain.size() - 1);
        double longest = 0;
        for (size_t i = 0; i < chain.size(); ++i) {
            const auto& end = skeleton_.joint(chain[i]).end_m;
            const double bone = i + 1 < chain.size() ? lengthOf(chain[i + 1]) : end ? end->norm() : 0;
            if (bone > longest && i > 0) {
                longest = bone;
                head = i;
            }
        }
        mapping_["Head"] = chain[head];
        if (head > 0)
            mapping_["Neck"] = neck;
    }

    const Skeleton& skeleton_;
    std::vector<Chain> children_;
    std::vector<double> length_;  ///< from the parent
    std::vector<double> reach_;   ///< to the farthest end below
    Pair legs_, arms_;
    JointMapping mapping_;
};

}  // namespace

JointMapping jointsByShape(const MotionClip& clip, const SeenMotion& seen) {
    JointMapping mapping = FigureShape(clip, seen).map();
    if (mapping.empty())
        return {};
    const Sides sides = judgeSides(clip, seen, mapping);
    return sides.unknown ? JointMapping() : exchanged(mapping, sides);
}

}  // namespace noctule::figure
