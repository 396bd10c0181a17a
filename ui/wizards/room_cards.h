// SPDX-License-Identifier: Apache-2.0
// What a survey says of a room, as cards below each other: its anchors, and what is wrong with a remedy. Each
// function fills a column anew.
#pragma once

#include <QString>
#include <functional>

#include "core/processing/survey_room.h"

class QBoxLayout;

namespace noctule::ui {

enum class SurveyStage { kWalking, kDone };

/// Which anchors are used, where that can be chosen.
struct AnchorChoice {
    std::function<QString(size_t anchor)> why_not_without;  ///< empty: it can be left out
    std::function<void(size_t anchor, bool is_without)> choose;
};
/// `choice` null: nothing can be chosen.
void showAnchorCards(QBoxLayout& column, const SurveyedTake& surveyed, SurveyStage stage,
                     const AnchorChoice* choice = nullptr);
/// While somebody walks the worst alone: most of it mends itself.
void showFindingCards(QBoxLayout& column, const SurveyedTake& surveyed, SurveyStage stage);
/// Nothing was found at all.
void showErrorCard(QBoxLayout& column, const Error& error);

}  // namespace noctule::ui
