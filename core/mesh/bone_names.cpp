// SPDX-License-Identifier: Apache-2.0
// Bones by the names that programs and data sets give them.
#include <algorithm>
#include <cctype>
#include <set>

#include "core/mesh/bone_map.h"
#include "core/mesh/rig_tree.h"

namespace noctule {
namespace {

/// A name in pieces: side 'L', 'R' or 0, and all else in small letters without separators.
struct PlainName {
    char side = 0;
    std::string base;
    bool operator<(const PlainName& other) const {
        return std::tie(side, base) < std::tie(other.side, other.base);
    }
};

/// "mixamorig:LeftUp_Leg.001" -> mixamorig dropped, {leftup, leg, 001}
std::vector<std::string> wordsOf(const std::string& name) {
    std::vector<std::string> words(1);
    for (const char c : name.substr(name.find_last_of(":|") + 1)) {
        if (std::isalnum(static_cast<unsigned char>(c)))
            words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!words.back().empty())
            words.emplace_back();
    }
    if (words.back().empty())
        words.pop_back();
    return words;
}

bool isPrefixWord(const std::string& word) {
    static const std::set<std::string> known = {"def", "org", "bip01", "bip001",
                                                "bip", "j",   "c",     "valvebiped"};
    return known.contains(word) || word == "mixamorig" ||
           (word.starts_with("mixamorig") && word.find_first_not_of("0123456789", 9) == std::string::npos);
}

PlainName plainName(std::vector<std::string> words) {
    PlainName plain;
    while (words.size() > 1 && isPrefixWord(words.front()))
        words.erase(words.begin());
    if (!words.empty() && words.front().starts_with("mixamorig"))
        words.front().erase(0, 9);
    for (const std::string& word : words) {
        if (!plain.side && (word == "l" || word == "left" || word == "r" || word == "right"))
            plain.side = word[0] == 'l' ? 'L' : 'R';
        else if (!plain.side && word.starts_with("left"))
            plain = {'L', plain.base + word.substr(4)};
        else if (!plain.side && word.starts_with("right"))
            plain = {'R', plain.base + word.substr(5)};
        else
            plain.base += word;
    }
    return plain;
}

/// The word before most names, such as "Character1_"; empty without one.
std::string commonFirstWord(const std::vector<std::vector<std::string>>& names) {
    std::map<std::string, size_t> count;
    for (const auto& words : names)
        if (words.size() > 1)
            ++count[words.front()];
    for (const auto& [word, times] : count)
        if (times > 5 && times * 5 > names.size() * 4 && word != "left" && word != "right")
            return word;
    return "";
}

/// Node by plain name; of several the first.
std::map<PlainName, int> plainNames(const RiggedMesh& mesh) {
    std::vector<std::vector<std::string>> names;
    for (const RigNode& node : mesh.nodes)
        names.push_back(wordsOf(node.name));
    const std::string first = commonFirstWord(names);
    std::map<PlainName, int> nodes;
    for (size_t n = 0; n < names.size(); ++n) {
        if (!first.empty() && names[n].size() > 1 && names[n].front() == first)
            names[n].erase(names[n].begin());
        nodes.try_emplace(plainName(names[n]), static_cast<int>(n));
    }
    return nodes;
}

/// Joint without its side -> names, the best first. "^": the side is a letter before the name, as in lfemur.
using Convention = std::map<std::string, std::vector<std::string>>;

const std::vector<Convention>& conventions() {
    static const std::vector<Convention> known = {
        // HumanIK, Mixamo, CMU's BVH, ours
        {{"Hips", {"hips"}},
         {"Spine", {"lowerback", "spine"}},
         {"Neck", {"neck"}},
         {"Head", {"head"}},
         {"*Shoulder", {"shoulder"}},
         {"*Arm", {"arm"}},
         {"*ForeArm", {"forearm"}},
         {"*Hand", {"hand"}},
         {"*UpLeg", {"upleg"}},
         {"*Leg", {"leg"}},
         {"*Foot", {"foot"}},
         {"*ToeBase", {"toebase", "toes", "toe"}}},
        // VRM and Unity, Xsens, VRoid
        {{"Hips", {"hips", "pelvis"}},
         {"Spine", {"spine", "l5"}},
         {"Neck", {"neck"}},
         {"Head", {"head"}},
         {"*Shoulder", {"shoulder"}},
         {"*Arm", {"upperarm"}},
         {"*ForeArm", {"lowerarm", "forearm"}},
         {"*Hand", {"hand"}},
         {"*UpLeg", {"upperleg"}},
         {"*Leg", {"lowerleg"}},
         {"*Foot", {"foot"}},
         {"*ToeBase", {"toes", "toe", "toebase"}}},
        // Rigify; its chain of "spine" begins at the hips and ends in the head
        {{"Hips", {"spine"}},
         {"Spine", {"spine001"}},
         {"Neck", {"spine004"}},
         {"Head", {"spine006", "spine005"}},
         {"*Shoulder", {"shoulder"}},
         {"*Arm", {"upperarm"}},
         {"*ForeArm", {"forearm"}},
         {"*Hand", {"hand"}},
         {"*UpLeg", {"thigh"}},
         {"*Leg", {"shin"}},
         {"*Foot", {"foot"}},
         {"*ToeBase", {"toe"}}},
        // MakeHuman's default rig
        {{"Hips", {"root"}},
         {"Spine", {"spine05"}},
         {"Neck", {"neck01"}},
         {"Head", {"head"}},
         {"*Shoulder", {"clavicle"}},
         {"*Arm", {"upperarm01"}},
         {"*ForeArm", {"lowerarm01"}},
         {"*Hand", {"wrist"}},
         {"*UpLeg", {"upperleg01"}},
         {"*Leg", {"lowerleg01"}},
         {"*Foot", {"foot"}},
         {"*ToeBase", {}}},
        // Unreal, MakeHuman's game rig, 3ds Max's Biped
        {{"Hips", {"pelvis"}},
         {"Spine", {"spine01", "spine"}},
         {"Neck", {"neck01", "neck"}},
         {"Head", {"head"}},
         {"*Shoulder", {"clavicle"}},
         {"*Arm", {"upperarm"}},
         {"*ForeArm", {"lowerarm", "forearm"}},
         {"*Hand", {"hand"}},
         {"*UpLeg", {"thigh"}},
         {"*Leg", {"calf"}},
         {"*Foot", {"foot"}},
         {"*ToeBase", {"ball", "toe0"}}},
        // CMU's ASF
        {{"Hips", {"root"}},
         {"Spine", {"lowerback"}},
         {"Neck", {"lowerneck"}},
         {"Head", {"head"}},
         {"*Shoulder", {"^clavicle"}},
         {"*Arm", {"^humerus"}},
         {"*ForeArm", {"^radius"}},
         {"*Hand", {"^hand", "^wrist"}},
         {"*UpLeg", {"^femur"}},
         {"*Leg", {"^tibia"}},
         {"*Foot", {"^foot"}},
         {"*ToeBase", {"^toes"}}},
    };
    return known;
}

PlainName sought(const std::string& name, char side) {
    if (!name.starts_with("^"))
        return {side, name};
    return {0, std::string(1, static_cast<char>(std::tolower(side))) + name.substr(1)};
}

void mapJoint(const RiggedMesh& mesh, const std::map<PlainName, int>& nodes, const std::string& joint,
              const std::vector<std::string>& names, char side, BoneMap& map) {
    for (const std::string& name : names)
        if (const auto found = nodes.find(sought(name, side)); found != nodes.end()) {
            map.node_of_joint[joint] = mesh.nodes[static_cast<size_t>(found->second)].name;
            return;
        }
}

/// The chest is where the arms part, whatever the vertebrae below it are called.
void mapChest(const RiggedMesh& mesh, BoneMap& map) {
    const auto node = [&](const char* joint) {
        const auto found = map.node_of_joint.find(joint);
        return found == map.node_of_joint.end() ? -1 : mesh.find(found->second);
    };
    const int left = node("LeftArm"), right = node("RightArm"), spine = node("Spine");
    if (left < 0 || right < 0 || spine < 0)
        return;
    const int chest = commonAncestor(mesh, left, right);
    if (chest >= 0 && chest != spine && hangsOn(mesh, chest, spine))
        map.node_of_joint["Chest"] = mesh.nodes[static_cast<size_t>(chest)].name;
}

BoneMap mapByConvention(const RiggedMesh& mesh, const std::map<PlainName, int>& nodes,
                        const Convention& convention) {
    BoneMap map;
    for (const auto& [joint, names] : convention) {
        if (joint[0] != '*') {
            mapJoint(mesh, nodes, joint, names, 0, map);
            continue;
        }
        mapJoint(mesh, nodes, "Left" + joint.substr(1), names, 'L', map);
        mapJoint(mesh, nodes, "Right" + joint.substr(1), names, 'R', map);
    }
    mapChest(mesh, map);
    return map;
}

}  // namespace

BoneMap mapByNames(const RiggedMesh& mesh) {
    const std::map<PlainName, int> nodes = plainNames(mesh);
    BoneMap best;
    for (const Convention& convention : conventions()) {
        BoneMap map = mapByConvention(mesh, nodes, convention);
        const size_t missing = missingMainJoints(map).size(), before = missingMainJoints(best).size();
        if (missing < before || (missing == before && map.node_of_joint.size() > best.node_of_joint.size()))
            best = std::move(map);
    }
    return best;
}

}  // namespace noctule
