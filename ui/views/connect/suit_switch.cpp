// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/suit_switch.h"

namespace noctule::ui {

SuitSwitch::SuitSwitch(Studio& studio, QWidget* parent)
    : PerformerButtons(tr("Shown"), parent), studio_(studio) {
    connect(&studio.suits(), &LiveSuits::changed, this, &SuitSwitch::refresh);
    connect(this, &PerformerButtons::chosen, this, [this](int index) {
        const auto suits = studio_.suits().connected();
        if (index < static_cast<int>(suits.size()))
            studio_.suits().setCurrent(*suits[static_cast<size_t>(index)]);
    });
    refresh();
}

void SuitSwitch::refresh() {
    LiveSuits& suits = studio_.suits();
    QStringList names;
    for (const SuitInUse* worn : suits.connected())
        names << suits.nameOf(*worn);
    setPerformers(names, suits.letterOf(suits.current()));
}

}  // namespace noctule::ui
