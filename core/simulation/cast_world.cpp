// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/cast_world.h"

#include "core/job/limits.h"

namespace noctule::simulation {
namespace {

int segmentOfCast(size_t suit, int segment) {
    return segment < 0 ? -1 : segment + static_cast<int>(suit * limits::kJoints);
}

}  // namespace

CastWorld::CastWorld(std::vector<const World*> suits, size_t speaker, std::optional<size_t> listener)
    : suits_(std::move(suits)), speaker_(speaker) {
    for (size_t suit = 0; suit < suits_.size(); ++suit)
        for (int board = 0; board < suits_[suit]->boardCount() && suit == listener.value_or(suit); ++board)
            boards_.push_back({suit, board});
}

Vector3d CastWorld::microphone(int board, double t_s) const {
    return suits_[boards_[board].suit]->microphone(boards_[board].board, t_s);
}

int CastWorld::boardSegment(int board) const {
    const BoardOfCast& owner = boards_[board];
    return segmentOfCast(owner.suit, suits_[owner.suit]->boardSegment(owner.board));
}

int CastWorld::sourceSegment(int source) const {
    return segmentOfCast(speaker_, suits_[speaker_]->sourceSegment(source));
}

int CastWorld::sourceBoard(int source) const {
    const int housing = suits_[speaker_]->sourceBoard(source);
    for (size_t board = 0; board < boards_.size() && housing >= 0; ++board)
        if (boards_[board].suit == speaker_ && boards_[board].board == housing)
            return static_cast<int>(board);
    return -1;
}

void CastWorld::capsules(double t_s, std::vector<WorldCapsule>& capsules) const {
    capsules.clear();
    for (size_t suit = 0; suit < suits_.size(); ++suit) {
        suits_[suit]->capsules(t_s, of_one_);
        for (WorldCapsule capsule : of_one_) {
            capsule.segment = segmentOfCast(suit, capsule.segment);
            capsules.push_back(capsule);
        }
    }
}

}  // namespace noctule::simulation
