// SPDX-License-Identifier: Apache-2.0
#include "core/body/bone_names.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <set>

namespace noctule {
namespace {

/// The roles of one chain from the body outwards, at most four.
struct ChainKind {
    std::vector<JointRole> roles;
    BodySide side;
};

const std::vector<ChainKind>& limbKinds() {
    using enum JointRole;
    static const std::vector<JointRole> arm = {kShoulder, kArm, kForeArm, kHand},
                                        leg = {kUpLeg, kLeg, kFoot, kToeBase};
    static const std::vector<ChainKind> kinds = {
        {arm, BodySide::kLeft}, {arm, BodySide::kRight}, {leg, BodySide::kLeft}, {leg, BodySide::kRight}};
    return kinds;
}

const ChainKind& headKind() {
    static const ChainKind kind = {{JointRole::kNeck, JointRole::kHead}, BodySide::kMiddle};
    return kind;
}

constexpr size_t kMostRoles = 4;
using RoleScores = std::array<double, kMostRoles>;

/// The chain down a tree whose bones play the roles in their order with the highest sum of scores; roles and
/// bones may be left out. Of equal chains the one nearest to the body. Solved from the tips inwards.
class ChainSearch {
public:
    ChainSearch(const std::vector<int>& parents, std::vector<RoleScores> scores)
        : scores_(std::move(scores)), children_(parents.size()), steps_(parents.size()) {
        for (size_t b = parents.size(); b-- > 0;) {
            for (size_t role = 0; role < kMostRoles; ++role)
                steps_[b][role] = bestFrom(b, role);
            if (parents[b] >= 0)
                children_[static_cast<size_t>(parents[b])].push_back(b);
        }
    }

    double total(size_t bone) const { return steps_[bone][0].total; }

    /// Bone per role in the tree below and with `top`; -1 for none.
    std::array<int, kMostRoles> chain(size_t top) const {
        std::array<int, kMostRoles> bones{-1, -1, -1, -1};
        int bone = static_cast<int>(top);
        for (size_t role = 0; bone >= 0 && role < kMostRoles;) {
            const Step& step = steps_[static_cast<size_t>(bone)][role];
            if (step.role >= 0) {
                bones[static_cast<size_t>(step.role)] = bone;
                role = static_cast<size_t>(step.role) + 1;
            }
            bone = step.next;
        }
        return bones;
    }

private:
    struct Step {
        double total = 0;
        int role = -1;  ///< that this bone plays
        int next = -1;  ///< the child along which the chain goes on
    };

    Step bestBelow(size_t bone, size_t role) const {
        Step best;
        for (auto child = children_[bone].rbegin(); role < kMostRoles && child != children_[bone].rend();
             ++child)
            if (const double total = steps_[*child][role].total; total > best.total)
                best = {total, -1, static_cast<int>(*child)};
        return best;
    }

    Step bestFrom(size_t bone, size_t role) const {
        Step best = bestBelow(bone, role);
        for (size_t played = role; played < kMostRoles; ++played) {
            if (scores_[bone][played] <= 0)
                continue;
            Step step = bestBelow(bone, played + 1);
            step.total += scores_[bone][played];
            step.role = static_cast<int>(played);
            if (step.total >= best.total)
                best = step;
        }
        return best;
    }

    std::vector<RoleScores> scores_;
    std::vector<std::vector<size_t>> children_;
    std::vector<std::array<Step, kMostRoles>> steps_;
};

class NamedBody {
public:
    explicit NamedBody(const std::vector<NamedBone>& bones) : bones_(bones) {
        for (const NamedBone& bone : bones) {
            spellings_.push_back(spellingOf(bone.name));
            parents_.push_back(bone.parent);
        }
        dropStrangePrefixes();
        is_list_ =
            bones.size() > 1 && std::all_of(parents_.begin(), parents_.end(), [](int p) { return p < 0; });
    }

    NamedJoints joints() {
        if (is_list_)
            return jointsOfList();
        std::vector<ChainSearch> limbs;
        for (const ChainKind& kind : limbKinds())
            limbs.emplace_back(parents_, scoresOf(kind));
        body_ = bodyTop(limbs);
        for (size_t k = 0; k < limbs.size() && body_ >= 0; ++k)
            take(limbKinds()[k], limbs[k].chain(static_cast<size_t>(body_)));
        mapHips();
        mapTrunk();
        mapHead();
        return std::move(found_);
    }

private:
    /// A prefix that no program is known for counts when a body carries it: six joints and more.
    void dropStrangePrefixes() {
        constexpr size_t kOfABody = 6;
        std::map<std::string, std::set<std::pair<BodySide, std::string>>> names_of_prefix;
        for (const BoneSpelling& spelling : spellings_)
            if (spelling.isKnown())
                names_of_prefix[spelling.prefix].insert({spelling.side, spelling.base});
        for (BoneSpelling& spelling : spellings_)
            if (spelling.isKnown() && !isKnownPrefix(spelling.prefix) &&
                names_of_prefix.at(spelling.prefix).size() < kOfABody)
                spelling = {};
    }

    double sureness(size_t bone) const {
        constexpr double kMovesNothing = 0.3, kRigifysOriginal = 0.9;
        return (bones_[bone].moves_skin ? 1 : kMovesNothing) *
               (spellings_[bone].prefix == "org" ? kRigifysOriginal : 1);
    }

    double scoreOf(size_t bone, JointRole role) const {
        for (const RoleReading& reading : spellings_[bone].readings)
            if (reading.role == role)
                return reading.score * sureness(bone);
        return 0;
    }

    std::vector<RoleScores> scoresOf(const ChainKind& kind) const {
        std::vector<RoleScores> scores(bones_.size(), RoleScores{});
        for (size_t b = 0; b < bones_.size(); ++b)
            if (spellings_[b].side == kind.side)
                for (size_t r = 0; r < kind.roles.size(); ++r)
                    scores[b][r] = scoreOf(b, kind.roles[r]);
        return scores;
    }

    void take(const ChainKind& kind, const std::array<int, kMostRoles>& chain) {
        for (size_t r = 0; r < kind.roles.size(); ++r)
            if (chain[r] >= 0)
                found_.bone_of_joint[canonicalJoint(kind.roles[r], kind.side)] = chain[r];
    }

    int of(const std::string& joint) const {
        const auto found = found_.bone_of_joint.find(joint);
        return found == found_.bone_of_joint.end() ? -1 : found->second;
    }

    int parentOf(int bone) const { return parents_[static_cast<size_t>(bone)]; }

    bool isBelow(int bone, int above) const {
        while (bone > above)
            bone = parentOf(bone);
        return bone == above;
    }

    /// -1 also when one of them is -1 or they hang in two trees.
    int commonAncestorOf(int a, int b) const {
        while (a != b && a >= 0 && b >= 0)
            (a > b ? a : b) = parentOf(std::max(a, b));
        return a == b ? a : -1;
    }

    /// The deepest bone below which all limbs of one body hang; -1 without any limb.
    int bodyTop(const std::vector<ChainSearch>& limbs) const {
        const auto total = [&](size_t bone) {
            return std::accumulate(limbs.begin(), limbs.end(), 0.0, [&](double sum, const ChainSearch& limb) {
                return sum + limb.total(bone);
            });
        };
        int top = -1;
        double most = 0;
        for (size_t b = 0; b < bones_.size(); ++b)
            if (total(b) > most + 1e-9) {
                most = total(b);
                top = static_cast<int>(b);
            }
        for (size_t b = 0; b < bones_.size() && top >= 0; ++b)
            if (parents_[b] == top && total(b) > most - 1e-9)
                top = static_cast<int>(b);
        return top;
    }

    int bestNamed(JointRole role) const {
        int best = -1;
        for (size_t b = 0; b < bones_.size(); ++b)
            if (spellings_[b].side == BodySide::kMiddle && scoreOf(b, role) > 0 &&
                (body_ < 0 || isBelow(static_cast<int>(b), treeOf(body_))) &&
                (best < 0 || scoreOf(b, role) > scoreOf(static_cast<size_t>(best), role)))
                best = static_cast<int>(b);
        return best;
    }

    int treeOf(int bone) const {
        while (parentOf(bone) >= 0)
            bone = parentOf(bone);
        return bone;
    }

    void mapHips() {
        chest_ = commonAncestorOf(firstOf("Left"), firstOf("Right"));
        while (chest_ >= 0 && scoreOf(static_cast<size_t>(chest_), JointRole::kNeck) > 1)
            chest_ = parentOf(chest_);  // arms that hang on the neck
        const int legs = commonAncestorOf(of("LeftUpLeg"), of("RightUpLeg"));
        const int both = chest_ < 0 ? legs : commonAncestorOf(legs, chest_);
        const int hips = both >= 0 ? both : legs >= 0 ? legs : bestNamed(JointRole::kHips);
        if (hips >= 0)
            found_.bone_of_joint["Hips"] = hips;
    }

    /// The bone by which an arm hangs on the trunk.
    int firstOf(const std::string& side) const {
        const int shoulder = of(side + "Shoulder");
        return shoulder >= 0 ? shoulder : of(side + "Arm");
    }

    /// From just below `above` down to `bone`.
    std::vector<int> between(int above, int bone) const {
        std::vector<int> chain;
        for (; bone > above; bone = parentOf(bone))
            chain.push_back(bone);
        std::reverse(chain.begin(), chain.end());
        return bone == above ? chain : std::vector<int>();
    }

    /// Where the arms do not show the chest: the highest vertebra by name.
    int chestByName(int hips) const {
        int best = -1;
        for (size_t b = 0; b < bones_.size(); ++b)
            if (spellings_[b].vertebra && static_cast<int>(b) != hips && isBelow(static_cast<int>(b), hips) &&
                (best < 0 || *spellings_[b].vertebra > *spellings_[static_cast<size_t>(best)].vertebra))
                best = static_cast<int>(b);
        return best;
    }

    void mapTrunk() {
        const int hips = of("Hips");
        if (hips < 0)
            return;
        if (chest_ < 0 || chest_ == hips)
            chest_ = chestByName(hips);
        if (chest_ < 0)
            return;
        found_.trunk = between(hips, chest_);
        if (found_.trunk.empty())
            return;
        const auto is_vertebra = [&](int bone) {
            return spellings_[static_cast<size_t>(bone)].vertebra.has_value();
        };
        const auto spine = std::find_if(found_.trunk.begin(), found_.trunk.end(), is_vertebra);
        found_.trunk.erase(found_.trunk.begin(), spine == found_.trunk.end() ? found_.trunk.begin() : spine);
        found_.bone_of_joint["Spine"] = found_.trunk.front();
        if (found_.trunk.size() > 1)
            found_.bone_of_joint["Chest"] = found_.trunk.back();
    }

    /// Below the chest, else anywhere in the body's tree.
    void mapHead() {
        const int above = chest_ >= 0 ? chest_ : of("Hips");
        std::vector<RoleScores> scores = scoresOf(headKind());
        for (size_t b = 0; b < bones_.size(); ++b)
            if (above >= 0 && (static_cast<int>(b) == above || !isBelow(static_cast<int>(b), above)))
                scores[b] = {};
        const ChainSearch search(parents_, scores);
        int top = -1;
        for (size_t b = 0; b < bones_.size(); ++b)
            if (search.total(b) > (top < 0 ? 0 : search.total(static_cast<size_t>(top))))
                top = static_cast<int>(b);
        if (top < 0)
            return;
        take(headKind(), search.chain(static_cast<size_t>(top)));
        if (above >= 0 && of("Head") >= 0)
            found_.neck = between(above, of("Head"));
    }

    /// Without a tree the mean role of each name gives the order along a limb.
    NamedJoints jointsOfList() {
        for (const ChainKind& kind : limbKinds())
            takeFromList(kind);
        takeFromList(headKind());
        if (const int hips = bestNamed(JointRole::kHips); hips >= 0)
            found_.bone_of_joint["Hips"] = hips;
        for (size_t b = 0; b < bones_.size(); ++b)
            if (const int bone = static_cast<int>(b);
                spellings_[b].vertebra && bone != of("Hips") && bone != of("Neck") && bone != of("Head"))
                found_.trunk.push_back(bone);
        std::stable_sort(found_.trunk.begin(), found_.trunk.end(), [&](int a, int b) {
            return *spellings_[static_cast<size_t>(a)].vertebra <
                   *spellings_[static_cast<size_t>(b)].vertebra;
        });
        if (!found_.trunk.empty())
            found_.bone_of_joint["Spine"] = found_.trunk.front();
        if (found_.trunk.size() > 1)
            found_.bone_of_joint["Chest"] = found_.trunk.back();
        return std::move(found_);
    }

    void takeFromList(const ChainKind& kind) {
        const std::vector<RoleScores> scores = scoresOf(kind);
        const auto sum = [&](size_t b) { return std::accumulate(scores[b].begin(), scores[b].end(), 0.0); };
        const auto place = [&](size_t b) {
            double weighted = 0;
            for (size_t r = 0; r < kMostRoles; ++r)
                weighted += static_cast<double>(r) * scores[b][r];
            return weighted / sum(b);
        };
        std::vector<size_t> order;
        for (size_t b = 0; b < bones_.size(); ++b)
            if (sum(b) > 0)
                order.push_back(b);
        std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return place(a) < place(b); });
        if (order.empty())
            return;
        std::vector<int> parents(order.size());
        std::iota(parents.begin(), parents.end(), -1);
        std::vector<RoleScores> ordered;
        for (const size_t b : order)
            ordered.push_back(scores[b]);
        std::array<int, kMostRoles> chain = ChainSearch(parents, ordered).chain(0);
        for (int& bone : chain)
            bone = bone < 0 ? -1 : static_cast<int>(order[static_cast<size_t>(bone)]);
        take(kind, chain);
    }

    const std::vector<NamedBone>& bones_;
    std::vector<BoneSpelling> spellings_;
    std::vector<int> parents_;
    bool is_list_ = false;
    int body_ = -1, chest_ = -1;
    NamedJoints found_;
};

}  // namespace

NamedJoints jointsByName(const std::vector<NamedBone>& bones) {
    return NamedBody(bones).joints();
}

const std::vector<std::string>& mainJoints() {
    static const std::vector<std::string> joints = {"Hips",        "Spine",     "Head",     "LeftArm",
                                                    "LeftForeArm", "LeftHand",  "RightArm", "RightForeArm",
                                                    "RightHand",   "LeftUpLeg", "LeftLeg",  "LeftFoot",
                                                    "RightUpLeg",  "RightLeg",  "RightFoot"};
    return joints;
}

std::vector<std::string> missingMainJoints(const std::map<std::string, int>& bone_of_joint) {
    std::vector<std::string> missing;
    for (const std::string& joint : mainJoints())
        if (!bone_of_joint.contains(joint))
            missing.push_back(joint);
    return missing;
}

}  // namespace noctule
