// SPDX-License-Identifier: Apache-2.0
// Segments, boards, sources and joints as the operator calls them, in the language of the studio. Numbers
// count from 1 here and nowhere else. Names that nobody knows (another maker's skeleton) are shown as they
// are.
#pragma once

#include <QString>
#include <map>
#include <string>
#include <vector>

#include "core/suit/suit.h"

namespace noctule::ui {

enum class NameCase {
    kTitle,   ///< stands alone: "Left shin"
    kInside,  ///< within a sentence or after a colon: "left shin"
};

/// "LeftLeg" -> "Left shin"; empty -> "Room".
QString segmentName(const std::string& segment, NameCase name_case = NameCase::kTitle);
/// The angle between a segment and the one before it: "LeftLeg" -> "Left knee".
QString jointName(const std::string& joint, NameCase name_case = NameCase::kTitle);

/// "Left shin"; of one that hangs in the room "ceiling 1".
QString boardName(const Board& board, NameCase name_case = NameCase::kTitle);
/// "Left shin (board 14)"
QString boardTitle(const Suit& suit, int board);
/// "board 14 (left shin)", within a sentence.
QString boardInside(const Suit& suit, int board);

/// "Hat", "Chest, left"
QString sourcePlace(const Source& source, NameCase name_case = NameCase::kTitle);
/// "source 8 (hat)", within a sentence.
QString sourceName(const Suit& suit, int source);
/// "Source 8 (hat)"
QString sourceTitle(const Suit& suit, int source);

/// Of boards and of sources by their ids, as they stand in tables. A board and a source may have one id.
struct PartNames {
    std::map<std::string, QString> boards, sources;

    /// `column`: "board" or "source", the head of the table's first one. Others' ids stay as they are.
    void apply(const std::string& column, std::string& id) const;
};
PartNames partNames(const Suit& suit);

/// "source 8 (hat) to left shin", as in legends.
QString pairName(const Suit& suit, int source, int board);

enum class BodyGroup { kTrunk, kLeftArm, kRightArm, kLeftLeg, kRightLeg, kElsewhere };

BodyGroup groupOfSegment(const std::string& segment);
/// "L arm", which has room below three columns.
QString groupName(BodyGroup group);

/// Boards of the suit by group, trunk first, within a group in the order of the suit; empty groups are left
/// out.
struct NamedBoards {
    BodyGroup group;
    std::vector<int> boards;
};
std::vector<NamedBoards> boardGroups(const Suit& suit);

}  // namespace noctule::ui
