// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/worn_part_names.h"

#include <algorithm>

#include "core/body/text.h"

namespace noctule {
namespace {

std::string numberAndId(int index, const std::string& id) {
    return std::to_string(index + 1) + ", " + id;
}

}  // namespace

std::string boardPlace(const Suit& suit, int board) {
    const Board& described = suit.boards[static_cast<size_t>(board)];
    return described.segment.empty() ? described.id : text::segmentLabel(described.segment);
}

std::string boardWords(const Suit& suit, int board) {
    return "board " + numberAndId(board, boardPlace(suit, board));
}

std::string boardName(const Suit& suit, int board) {
    return text::capitalised(boardWords(suit, board));
}

std::string boardInList(const Suit& suit, int board) {
    return std::to_string(board + 1) + " (" + boardPlace(suit, board) + ")";
}

std::string sourceName(const Suit& suit, int source) {
    std::string place = suit.sources[static_cast<size_t>(source)].id;
    if (place.ends_with("_l"))
        place.replace(place.size() - 2, 2, " left");
    if (place.ends_with("_r"))
        place.replace(place.size() - 2, 2, " right");
    std::ranges::replace(place, '_', ' ');
    return "Source " + numberAndId(source, place);
}

}  // namespace noctule
