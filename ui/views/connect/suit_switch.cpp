// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/suit_switch.h"

namespace noctule::ui {

SuitSwitch::SuitSwitch(CaptureContext& capture, QWidget* parent)
    : PerformerButtons(tr("Shown"), parent), capture_(capture) {
    connect(&capture.suits(), &LiveSuits::changed, this, &SuitSwitch::refresh);
    connect(this, &PerformerButtons::chosen, this, &SuitSwitch::choose);
    refresh();
}

void SuitSwitch::choose(int index) {
    const auto suits = capture_.suits().connected();
    if (index >= static_cast<int>(suits.size()))
        return;
    capture_.suits().setCurrent(*suits[static_cast<size_t>(index)]);
}

void SuitSwitch::refresh() {
    LiveSuits& suits = capture_.suits();
    QStringList names;
    for (const SuitInUse* worn : suits.connected())
        names << suits.nameOf(*worn);
    setPerformers(names, suits.letterOf(suits.current()));
}

}  // namespace noctule::ui
