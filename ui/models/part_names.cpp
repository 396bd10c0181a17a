// SPDX-License-Identifier: Apache-2.0
#include "ui/models/part_names.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <span>

namespace noctule::ui {
namespace {

constexpr const char* kContext = "PartNames";

/// Both cases are translated each for itself: other languages write them differently.
struct Words {
    const char* key;
    const char* title;
    const char* inside;
};

constexpr Words kSegments[] = {
    {"", QT_TRANSLATE_NOOP("PartNames", "Room"), QT_TRANSLATE_NOOP("PartNames", "room")},
    {"Hips", QT_TRANSLATE_NOOP("PartNames", "Pelvis"), QT_TRANSLATE_NOOP("PartNames", "pelvis")},
    {"Spine", QT_TRANSLATE_NOOP("PartNames", "Abdomen"), QT_TRANSLATE_NOOP("PartNames", "abdomen")},
    {"Chest", QT_TRANSLATE_NOOP("PartNames", "Chest"), QT_TRANSLATE_NOOP("PartNames", "chest")},
    {"Neck", QT_TRANSLATE_NOOP("PartNames", "Neck"), QT_TRANSLATE_NOOP("PartNames", "neck")},
    {"Head", QT_TRANSLATE_NOOP("PartNames", "Head"), QT_TRANSLATE_NOOP("PartNames", "head")},
    {"LeftShoulder", QT_TRANSLATE_NOOP("PartNames", "Left clavicle"),
     QT_TRANSLATE_NOOP("PartNames", "left clavicle")},
    {"LeftArm", QT_TRANSLATE_NOOP("PartNames", "Left upper arm"),
     QT_TRANSLATE_NOOP("PartNames", "left upper arm")},
    {"LeftForeArm", QT_TRANSLATE_NOOP("PartNames", "Left forearm"),
     QT_TRANSLATE_NOOP("PartNames", "left forearm")},
    {"LeftHand", QT_TRANSLATE_NOOP("PartNames", "Left hand"), QT_TRANSLATE_NOOP("PartNames", "left hand")},
    {"LeftUpLeg", QT_TRANSLATE_NOOP("PartNames", "Left thigh"), QT_TRANSLATE_NOOP("PartNames", "left thigh")},
    {"LeftLeg", QT_TRANSLATE_NOOP("PartNames", "Left shin"), QT_TRANSLATE_NOOP("PartNames", "left shin")},
    {"LeftFoot", QT_TRANSLATE_NOOP("PartNames", "Left foot"), QT_TRANSLATE_NOOP("PartNames", "left foot")},
    {"LeftToeBase", QT_TRANSLATE_NOOP("PartNames", "Left toes"), QT_TRANSLATE_NOOP("PartNames", "left toes")},
    {"RightShoulder", QT_TRANSLATE_NOOP("PartNames", "Right clavicle"),
     QT_TRANSLATE_NOOP("PartNames", "right clavicle")},
    {"RightArm", QT_TRANSLATE_NOOP("PartNames", "Right upper arm"),
     QT_TRANSLATE_NOOP("PartNames", "right upper arm")},
    {"RightForeArm", QT_TRANSLATE_NOOP("PartNames", "Right forearm"),
     QT_TRANSLATE_NOOP("PartNames", "right forearm")},
    {"RightHand", QT_TRANSLATE_NOOP("PartNames", "Right hand"), QT_TRANSLATE_NOOP("PartNames", "right hand")},
    {"RightUpLeg", QT_TRANSLATE_NOOP("PartNames", "Right thigh"),
     QT_TRANSLATE_NOOP("PartNames", "right thigh")},
    {"RightLeg", QT_TRANSLATE_NOOP("PartNames", "Right shin"), QT_TRANSLATE_NOOP("PartNames", "right shin")},
    {"RightFoot", QT_TRANSLATE_NOOP("PartNames", "Right foot"), QT_TRANSLATE_NOOP("PartNames", "right foot")},
    {"RightToeBase", QT_TRANSLATE_NOOP("PartNames", "Right toes"),
     QT_TRANSLATE_NOOP("PartNames", "right toes")},
};

// The default actor's neck is rigid: its head carries the rotation of the whole neck.
constexpr Words kJoints[] = {
    {"Hips", QT_TRANSLATE_NOOP("PartNames", "Pelvis"), QT_TRANSLATE_NOOP("PartNames", "pelvis")},
    {"Spine", QT_TRANSLATE_NOOP("PartNames", "Lower back"), QT_TRANSLATE_NOOP("PartNames", "lower back")},
    {"Chest", QT_TRANSLATE_NOOP("PartNames", "Upper back"), QT_TRANSLATE_NOOP("PartNames", "upper back")},
    {"Neck", QT_TRANSLATE_NOOP("PartNames", "Base of the neck"),
     QT_TRANSLATE_NOOP("PartNames", "base of the neck")},
    {"Head", QT_TRANSLATE_NOOP("PartNames", "Neck"), QT_TRANSLATE_NOOP("PartNames", "neck")},
    {"LeftShoulder", QT_TRANSLATE_NOOP("PartNames", "Left clavicle"),
     QT_TRANSLATE_NOOP("PartNames", "left clavicle")},
    {"LeftArm", QT_TRANSLATE_NOOP("PartNames", "Left shoulder"),
     QT_TRANSLATE_NOOP("PartNames", "left shoulder")},
    {"LeftForeArm", QT_TRANSLATE_NOOP("PartNames", "Left elbow"),
     QT_TRANSLATE_NOOP("PartNames", "left elbow")},
    {"LeftHand", QT_TRANSLATE_NOOP("PartNames", "Left wrist"), QT_TRANSLATE_NOOP("PartNames", "left wrist")},
    {"LeftUpLeg", QT_TRANSLATE_NOOP("PartNames", "Left hip"), QT_TRANSLATE_NOOP("PartNames", "left hip")},
    {"LeftLeg", QT_TRANSLATE_NOOP("PartNames", "Left knee"), QT_TRANSLATE_NOOP("PartNames", "left knee")},
    {"LeftFoot", QT_TRANSLATE_NOOP("PartNames", "Left ankle"), QT_TRANSLATE_NOOP("PartNames", "left ankle")},
    {"LeftToeBase", QT_TRANSLATE_NOOP("PartNames", "Left toes"), QT_TRANSLATE_NOOP("PartNames", "left toes")},
    {"RightShoulder", QT_TRANSLATE_NOOP("PartNames", "Right clavicle"),
     QT_TRANSLATE_NOOP("PartNames", "right clavicle")},
    {"RightArm", QT_TRANSLATE_NOOP("PartNames", "Right shoulder"),
     QT_TRANSLATE_NOOP("PartNames", "right shoulder")},
    {"RightForeArm", QT_TRANSLATE_NOOP("PartNames", "Right elbow"),
     QT_TRANSLATE_NOOP("PartNames", "right elbow")},
    {"RightHand", QT_TRANSLATE_NOOP("PartNames", "Right wrist"),
     QT_TRANSLATE_NOOP("PartNames", "right wrist")},
    {"RightUpLeg", QT_TRANSLATE_NOOP("PartNames", "Right hip"), QT_TRANSLATE_NOOP("PartNames", "right hip")},
    {"RightLeg", QT_TRANSLATE_NOOP("PartNames", "Right knee"), QT_TRANSLATE_NOOP("PartNames", "right knee")},
    {"RightFoot", QT_TRANSLATE_NOOP("PartNames", "Right ankle"),
     QT_TRANSLATE_NOOP("PartNames", "right ankle")},
    {"RightToeBase", QT_TRANSLATE_NOOP("PartNames", "Right toes"),
     QT_TRANSLATE_NOOP("PartNames", "right toes")},
};

constexpr Words kSources[] = {
    {"chest_l", QT_TRANSLATE_NOOP("PartNames", "Chest, left"), QT_TRANSLATE_NOOP("PartNames", "chest, left")},
    {"chest_r", QT_TRANSLATE_NOOP("PartNames", "Chest, right"),
     QT_TRANSLATE_NOOP("PartNames", "chest, right")},
    {"rib_l", QT_TRANSLATE_NOOP("PartNames", "Ribs, left"), QT_TRANSLATE_NOOP("PartNames", "ribs, left")},
    {"rib_r", QT_TRANSLATE_NOOP("PartNames", "Ribs, right"), QT_TRANSLATE_NOOP("PartNames", "ribs, right")},
    {"navel", QT_TRANSLATE_NOOP("PartNames", "Navel"), QT_TRANSLATE_NOOP("PartNames", "navel")},
    {"belly_l", QT_TRANSLATE_NOOP("PartNames", "Belly, left"), QT_TRANSLATE_NOOP("PartNames", "belly, left")},
    {"belly_r", QT_TRANSLATE_NOOP("PartNames", "Belly, right"),
     QT_TRANSLATE_NOOP("PartNames", "belly, right")},
    {"hat", QT_TRANSLATE_NOOP("PartNames", "Hat"), QT_TRANSLATE_NOOP("PartNames", "hat")},
};

/// Names of others appear as they are, "l_ear" as "l ear".
QString nameFrom(std::span<const Words> words, const std::string& key, NameCase name_case) {
    const auto found = std::find_if(words.begin(), words.end(), [&](const Words& w) { return key == w.key; });
    if (found == words.end())
        return QString::fromStdString(key).replace('_', ' ');
    return QCoreApplication::translate(kContext,
                                       name_case == NameCase::kTitle ? found->title : found->inside);
}

const Board& boardOf(const Suit& suit, int board) {
    return suit.boards.at(static_cast<size_t>(board));
}

const Source& sourceOf(const Suit& suit, int source) {
    return suit.sources.at(static_cast<size_t>(source));
}

}  // namespace

QString segmentName(const std::string& segment, NameCase name_case) {
    return nameFrom(kSegments, segment, name_case);
}

QString jointName(const std::string& joint, NameCase name_case) {
    return nameFrom(kJoints, joint, name_case);
}

QString boardName(const Board& board, NameCase name_case) {
    return board.segment.empty() ? nameFrom({}, board.id, name_case) : segmentName(board.segment, name_case);
}

QString boardTitle(const Suit& suit, int board) {
    return QCoreApplication::translate("PartNames", "%1 (board %2)", "Left shin (board 14)")
        .arg(boardName(boardOf(suit, board)))
        .arg(board + 1);
}

QString boardInside(const Suit& suit, int board) {
    return QCoreApplication::translate("PartNames", "board %1 (%2)", "board 14 (left shin)")
        .arg(board + 1)
        .arg(boardName(boardOf(suit, board), NameCase::kInside));
}

QString sourcePlace(const Source& source, NameCase name_case) {
    return nameFrom(kSources, source.id, name_case);
}

QString sourceName(const Suit& suit, int source) {
    return QCoreApplication::translate("PartNames", "source %1 (%2)", "source 8 (hat)")
        .arg(source + 1)
        .arg(sourcePlace(sourceOf(suit, source), NameCase::kInside));
}

QString sourceTitle(const Suit& suit, int source) {
    return QCoreApplication::translate("PartNames", "Source %1 (%2)", "Source 8 (hat)")
        .arg(source + 1)
        .arg(sourcePlace(sourceOf(suit, source), NameCase::kInside));
}

PartNames partNames(const Suit& suit) {
    PartNames names;
    for (const Board& board : suit.boards)
        names.boards[board.id] = boardName(board);
    for (int source = 0; source < static_cast<int>(suit.sources.size()); ++source)
        names.sources[suit.sources[static_cast<size_t>(source)].id] = sourceTitle(suit, source);
    return names;
}

void PartNames::apply(const std::string& column, std::string& id) const {
    const bool of_sources = column == "source";
    for (const auto* names : {of_sources ? &sources : &boards, of_sources ? &boards : &sources})
        if (const auto known = names->find(id); known != names->end()) {
            id = known->second.toStdString();
            return;
        }
}

QString pairName(const Suit& suit, int source, int board) {
    return QCoreApplication::translate("PartNames", "%1 to %2", "source 8 (hat) to left shin")
        .arg(sourceName(suit, source), boardName(boardOf(suit, board), NameCase::kInside));
}

BodyGroup groupOfSegment(const std::string& segment) {
    const bool left = segment.starts_with("Left");
    if (left || segment.starts_with("Right")) {
        const std::string part = segment.substr(left ? 4 : 5);
        if (part == "Shoulder" || part == "Arm" || part == "ForeArm" || part == "Hand")
            return left ? BodyGroup::kLeftArm : BodyGroup::kRightArm;
        if (part == "UpLeg" || part == "Leg" || part == "Foot" || part == "ToeBase")
            return left ? BodyGroup::kLeftLeg : BodyGroup::kRightLeg;
    }
    constexpr std::array kTrunk{"Hips", "Spine", "Chest", "Neck", "Head"};
    const bool trunk = std::find(kTrunk.begin(), kTrunk.end(), segment) != kTrunk.end();
    return trunk ? BodyGroup::kTrunk : BodyGroup::kElsewhere;
}

QString groupName(BodyGroup group) {
    switch (group) {
        case BodyGroup::kTrunk:
            return QCoreApplication::translate("PartNames", "Trunk");
        case BodyGroup::kLeftArm:
            return QCoreApplication::translate("PartNames", "L arm", "left arm, short");
        case BodyGroup::kRightArm:
            return QCoreApplication::translate("PartNames", "R arm", "right arm, short");
        case BodyGroup::kLeftLeg:
            return QCoreApplication::translate("PartNames", "L leg", "left leg, short");
        case BodyGroup::kRightLeg:
            return QCoreApplication::translate("PartNames", "R leg", "right leg, short");
        case BodyGroup::kElsewhere:
            break;
    }
    return QCoreApplication::translate("PartNames", "Elsewhere",
                                       "boards that sit on no known part of the body");
}

std::vector<NamedBoards> boardGroups(const Suit& suit) {
    std::vector<NamedBoards> groups;
    for (const BodyGroup group : {BodyGroup::kTrunk, BodyGroup::kLeftArm, BodyGroup::kRightArm,
                                  BodyGroup::kLeftLeg, BodyGroup::kRightLeg, BodyGroup::kElsewhere}) {
        NamedBoards members{group, {}};
        for (size_t b = 0; b < suit.boards.size(); ++b)
            if (groupOfSegment(suit.boards[b].segment) == group)
                members.boards.push_back(static_cast<int>(b));
        if (!members.boards.empty())
            groups.push_back(std::move(members));
    }
    return groups;
}

}  // namespace noctule::ui
