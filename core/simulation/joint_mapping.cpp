// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/joint_mapping.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace noctule::simulation {
namespace {

/// A source joint's name taken apart: side ("Left", "Right" or empty) and the rest in lower case, letters and
/// digits only.
struct PlainName {
    std::string side, rest;
};

std::string lettersOf(const std::string& text) {
    std::string letters;
    for (const char c : text)
        if (std::isalnum(static_cast<unsigned char>(c)))
            letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return letters;
}

bool takeSideMark(std::string& name, const std::string& mark) {
    const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
    const auto found = std::search(name.begin(), name.end(), mark.begin(), mark.end(), same);
    // Words stand anywhere; single letters only after or before a separator at the name's end or start.
    const bool word = mark.size() > 2;
    const bool at_end = mark.front() == '.' || mark.front() == '_';
    if (found == name.end() || (!word && at_end && name.end() - found != 2) ||
        (!word && !at_end && found != name.begin()))
        return false;
    name.erase(found, found + static_cast<std::ptrdiff_t>(mark.size()));
    return true;
}

/// Poser's way: "lShldr", "rThigh".
bool takeSideLetter(std::string& name, char letter) {
    const bool marked =
        name.size() > 1 && name[0] == letter && std::isupper(static_cast<unsigned char>(name[1]));
    if (marked)
        name.erase(0, 1);
    return marked;
}

PlainName plainName(const std::string& joint) {
    std::string name = joint.substr(joint.rfind(':') == std::string::npos ? 0 : joint.rfind(':') + 1);
    if (name.starts_with("__"))  // MakeHuman's helper joints repeat the name of the real one
        return {"", ""};
    for (const auto& [side, marks] :
         {std::pair{"Left", std::vector<std::string>{"left", ".l", "_l", "l_"}},
          std::pair{"Right", std::vector<std::string>{"right", ".r", "_r", "r_"}}})
        for (const std::string& mark : marks)
            if (takeSideMark(name, mark))
                return {side, lettersOf(name)};
    for (const auto& [side, letter] : {std::pair{"Left", 'l'}, std::pair{"Right", 'r'}})
        if (takeSideLetter(name, letter))
            return {side, lettersOf(name)};
    return {"", lettersOf(name)};
}

/// First source joint of that side whose plain name is one of the spellings, the earlier spelling winning.
int findSpelling(const Skeleton& source, const std::string& side, const std::vector<std::string>& spellings) {
    for (const std::string& spelling : spellings)
        for (int j = 0; j < source.size(); ++j) {
            const PlainName name = plainName(source.joint(j).name);
            if (name.side == side && name.rest == spelling)
                return j;
        }
    return -1;
}

struct Spellings {
    const char* canonical;
    std::vector<std::string> accepted;
};

/// In Biovision files "Shoulder" and "Hip" are the limb's joints, so the limbs are looked up first.
const std::vector<Spellings>& limbSpellings() {
    static const std::vector<Spellings> spellings = {
        {"Arm", {"arm", "upperarm", "upperarm01", "uparm", "shldr", "shoulder"}},
        {"ForeArm", {"forearm", "lowerarm", "lowerarm01", "loarm", "elbow"}},
        {"Hand", {"hand", "wrist"}},
        {"UpLeg", {"upleg", "upperleg", "upperleg01", "thigh", "hip"}},
        {"Leg", {"leg", "lowerleg", "lowerleg01", "loleg", "lowleg", "shin", "calf", "knee"}},
        {"Foot", {"foot", "ankle"}},
        {"ToeBase", {"toebase", "toe", "toes", "toe11", "toe1"}},
        {"Shoulder", {"clavicle", "collar", "shoulder"}},
    };
    return spellings;
}

std::vector<int> pathToRoot(const Skeleton& source, int joint) {
    std::vector<int> path;
    for (int j = joint; j >= 0; j = source.joint(j).parent)
        path.push_back(j);
    return path;
}

int commonAncestor(const Skeleton& source, int a, int b) {
    const std::vector<int> above_b = pathToRoot(source, b);
    for (const int j : pathToRoot(source, a))
        if (std::find(above_b.begin(), above_b.end(), j) != above_b.end())
            return j;
    return 0;
}

/// Hips carry both thighs, the chest carries both arms, the spine is half way between.
void mapTrunk(const Skeleton& source, JointMapping& mapping) {
    const int hips = commonAncestor(source, mapping.at("LeftUpLeg"), mapping.at("RightUpLeg"));
    const int chest = commonAncestor(source, mapping.at("LeftArm"), mapping.at("RightArm"));
    mapping["Hips"] = hips;
    if (chest != hips) {
        mapping["Chest"] = chest;
        std::vector<int> between;  // from the chest down to the hips, both excluded
        for (int j = source.joint(chest).parent; j >= 0 && j != hips; j = source.joint(j).parent)
            between.push_back(j);
        if (!between.empty())
            mapping["Spine"] = between[(between.size() - 1) / 2];
    }
    for (const auto& [canonical, spellings] :
         {std::pair{"Neck", std::vector<std::string>{"neck", "neck01", "lowerneck"}},
          std::pair{"Head", std::vector<std::string>{"head"}}})
        if (const int joint = findSpelling(source, "", spellings); joint >= 0)
            mapping[canonical] = joint;
}

}  // namespace

Result<JointMapping> mapJoints(const Skeleton& source, const std::string& where) {
    JointMapping mapping;
    std::string missing;
    for (const std::string side : {"Left", "Right"})
        for (const Spellings& limb : limbSpellings()) {
            const int joint = findSpelling(source, side, limb.accepted);
            const std::string name = limb.canonical;
            if (joint >= 0 && !(name == "Shoulder" && joint == mapping[side + "Arm"]))
                mapping[side + name] = joint;
            else if (name == "Arm" || name == "ForeArm" || name == "UpLeg" || name == "Leg")
                missing += (missing.empty() ? "" : ", ") + side + name;
        }
    if (!missing.empty())
        return Error{
            ErrorKind::kUnusable, where + ": no joint was recognised as " + missing,
            "Rename the file's joints after HumanIK, for example LeftUpLeg, LeftLeg, LeftArm, LeftForeArm"};
    mapTrunk(source, mapping);
    return mapping;
}

}  // namespace noctule::simulation
