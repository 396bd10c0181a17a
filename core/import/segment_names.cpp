// SPDX-License-Identifier: Apache-2.0
#include "core/import/segment_names.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <vector>

#include "core/body/bone_spelling.h"

namespace noctule {

namespace {

using enum JointRole;

/// What makers of sensors and OpenSim's models call the parts of a body; bone_spelling.h knows programs'
/// words.
const std::map<std::string, JointRole>& sensorWords() {
    static const std::map<std::string, JointRole> words = {
        {"hip", kHips},         {"hips", kHips},         {"pelvis", kHips},       {"sacrum", kHips},
        {"root", kHips},        {"waist", kHips},        {"spine", kSpine},       {"lowerback", kSpine},
        {"lumbar", kSpine},     {"l5", kSpine},          {"l3", kSpine},          {"chest", kChest},
        {"torso", kChest},      {"thorax", kChest},      {"sternum", kChest},     {"upperback", kChest},
        {"t8", kChest},         {"trunk", kChest},       {"neck", kNeck},         {"head", kHead},
        {"skull", kHead},       {"shoulder", kShoulder}, {"clavicle", kShoulder}, {"scapula", kShoulder},
        {"arm", kArm},          {"upperarm", kArm},      {"humerus", kArm},       {"forearm", kForeArm},
        {"lowerarm", kForeArm}, {"radius", kForeArm},    {"ulna", kForeArm},      {"hand", kHand},
        {"upleg", kUpLeg},      {"upperleg", kUpLeg},    {"thigh", kUpLeg},       {"femur", kUpLeg},
        {"leg", kLeg},          {"lowerleg", kLeg},      {"shank", kLeg},         {"shin", kLeg},
        {"tibia", kLeg},        {"calf", kLeg},          {"foot", kFoot},         {"calcn", kFoot},
        {"toe", kToeBase},      {"toes", kToeBase},      {"toebase", kToeBase}};
    return words;
}

/// "RightUpperArm 64F0EDBF" -> right, upper, arm, 64f0edbf.
std::vector<std::string> wordsOf(const std::string& name) {
    std::vector<std::string> words(1);
    for (size_t i = 0; i < name.size(); ++i) {
        const auto c = static_cast<unsigned char>(name[i]);
        const bool hump = i > 0 && std::isupper(c) && std::islower(static_cast<unsigned char>(name[i - 1]));
        if (!std::isalnum(c) || hump)
            words.emplace_back();
        if (std::isalnum(c))
            words.back() += char(std::tolower(c));
    }
    std::erase(words, "");
    return words;
}

BodySide takeSide(std::vector<std::string>& words) {
    for (auto word = words.begin(); word != words.end(); ++word) {
        const bool left = *word == "l" || *word == "left" || *word == "lt";
        if (!left && *word != "r" && *word != "right" && *word != "rt")
            continue;
        words.erase(word);
        return left ? BodySide::kLeft : BodySide::kRight;
    }
    return BodySide::kMiddle;
}

bool hasSides(JointRole role) {
    return role != kHips && role != kSpine && role != kChest && role != kNeck && role != kHead;
}

}  // namespace

std::optional<std::string> segmentByName(const std::string& sensor) {
    std::vector<std::string> words = wordsOf(sensor.substr(0, 200));
    const BodySide side = takeSide(words);
    for (size_t count = 2; count >= 1; --count)
        for (size_t first = 0; first + count <= words.size(); ++first) {
            const std::string joined = words[first] + (count == 2 ? words[first + 1] : "");
            const auto found = sensorWords().find(joined);
            if (found != sensorWords().end() && hasSides(found->second) == (side != BodySide::kMiddle))
                return canonicalJoint(found->second, side);
        }
    const BoneSpelling spelling = spellingOf(sensor);
    const auto best = std::max_element(spelling.readings.begin(), spelling.readings.end(),
                                       [](const auto& a, const auto& b) { return a.score < b.score; });
    if (best == spelling.readings.end() || hasSides(best->role) != (spelling.side != BodySide::kMiddle))
        return std::nullopt;
    return canonicalJoint(best->role, spelling.side);
}

void guessSegments(ImportedRecording& recording) {
    std::map<std::string, int> claims;
    for (ImportedSensor& sensor : recording.sensors) {
        if (sensor.segment.empty())
            sensor.segment = segmentByName(sensor.id).value_or("");
        ++claims[sensor.segment];
    }
    for (const auto& [segment, count] : claims) {
        if (segment.empty() || count == 1)
            continue;
        recording.warnings.push_back(std::to_string(count) + " sensors are named for " + segment +
                                     "; none of them was put there");
        for (ImportedSensor& sensor : recording.sensors)
            if (sensor.segment == segment)
                sensor.segment.clear();
    }
}

}  // namespace noctule
