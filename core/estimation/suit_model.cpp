// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/suit_model.h"

#include "core/suit/placed_suit.h"

namespace noctule {
namespace {

/// Link of a segment, -1 for the world.
int linkOf(const std::string& segment, const Actor& actor, const KinematicTree& tree) {
    return segment.empty() ? -1 : tree.linkOfJoint(actor.skeleton.find(segment));
}

}  // namespace

Result<SuitModel> mountSuit(const Suit& suit, const Calibration& calibration, const Actor& actor,
                            const KinematicTree& tree) {
    std::vector<std::string> names;
    for (const Joint& joint : actor.skeleton.joints())
        names.push_back(joint.name);
    Status checked = checkSegments(suit, names, "suit " + suit.name);
    if (!checked)
        return checked.error();
    SuitModel model;
    const Suit placed = placedSuit(suit, calibration);
    for (const Board& board : placed.boards) {
        const Vector3d p = board.p_segment_board_m;
        const Quaterniond q = board.q_segment_board;
        model.boards.push_back(
            {linkOf(board.segment, actor, tree), p, q.toRotationMatrix(), p + q * board.p_board_mic_m});
    }
    for (const Source& source : placed.sources)
        model.sources.push_back(
            {linkOf(source.segment, actor, tree), source.p_segment_source_m, source.normal_segment});
    return model;
}

}  // namespace noctule
