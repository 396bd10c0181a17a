// SPDX-License-Identifier: Apache-2.0
// Bones by the names that programs and data sets give them.
#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <sstream>

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

/// What a convention calls a joint, without its side; "*": there is one on each side. The names of a row are
/// in this order.
constexpr std::array kNamedJoints = {"Hips",     "Spine", "Neck",   "Head", "*Shoulder", "*Arm",
                                     "*ForeArm", "*Hand", "*UpLeg", "*Leg", "*Foot",     "*ToeBase"};

/// Names of one joint with spaces between, the best first. "^": the side is a letter before the name, as in
/// lfemur.
using Convention = std::array<const char*, kNamedJoints.size()>;

constexpr Convention kConventions[] = {
    // HumanIK, Mixamo, CMU's BVH, ours
    {"hips", "lowerback spine", "neck", "head", "shoulder", "arm", "forearm", "hand", "upleg", "leg", "foot",
     "toebase toes toe"},
    // VRM and Unity, Xsens, VRoid
    {"hips pelvis", "spine l5", "neck", "head", "shoulder", "upperarm", "lowerarm forearm", "hand",
     "upperleg", "lowerleg", "foot", "toes toe toebase"},
    // Xsens' BVH and others of Biovision's kind
    {"hips", "chest", "neck", "head", "collar", "shoulder", "elbow", "wrist", "hip", "knee", "ankle", "toe"},
    // Rigify; its chain of "spine" begins at the hips and ends in the head
    {"spine", "spine001", "spine004", "spine006 spine005", "shoulder", "upperarm", "forearm", "hand", "thigh",
     "shin", "foot", "toe"},
    // MakeHuman's default rig
    {"root", "spine05", "neck01", "head", "clavicle", "upperarm01", "lowerarm01", "wrist", "upperleg01",
     "lowerleg01", "foot", ""},
    // Unreal, MakeHuman's game rig, 3ds Max's Biped
    {"pelvis", "spine01 spine", "neck01 neck", "head", "clavicle", "upperarm", "lowerarm forearm", "hand",
     "thigh", "calf", "foot", "ball toe0"},
    // CMU's ASF
    {"root", "lowerback", "lowerneck", "head", "^clavicle", "^humerus", "^radius", "^hand ^wrist", "^femur",
     "^tibia", "^foot", "^toes"},
};

PlainName sought(const std::string& name, char side) {
    if (!name.starts_with("^"))
        return {side, name};
    return {0, std::string(1, static_cast<char>(std::tolower(side))) + name.substr(1)};
}

void mapJoint(const RiggedMesh& mesh, const std::map<PlainName, int>& nodes, const std::string& joint,
              const char* names, char side, BoneMap& map) {
    std::istringstream words(names);
    for (std::string name; words >> name;)
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
    for (size_t j = 0; j < kNamedJoints.size(); ++j) {
        const std::string joint = kNamedJoints[j];
        if (joint[0] != '*') {
            mapJoint(mesh, nodes, joint, convention[j], 0, map);
            continue;
        }
        mapJoint(mesh, nodes, "Left" + joint.substr(1), convention[j], 'L', map);
        mapJoint(mesh, nodes, "Right" + joint.substr(1), convention[j], 'R', map);
    }
    mapChest(mesh, map);
    return map;
}

}  // namespace

BoneMap mapByNames(const RiggedMesh& mesh) {
    const std::map<PlainName, int> nodes = plainNames(mesh);
    BoneMap best;
    for (const Convention& convention : kConventions) {
        BoneMap map = mapByConvention(mesh, nodes, convention);
        const size_t missing = missingMainJoints(map).size(), before = missingMainJoints(best).size();
        if (missing < before || (missing == before && map.node_of_joint.size() > best.node_of_joint.size()))
            best = std::move(map);
    }
    return best;
}

}  // namespace noctule
