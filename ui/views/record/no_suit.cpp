// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/no_suit.h"

#include <QVBoxLayout>

#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

NoSuit::NoSuit(CaptureContext& capture, QWidget* parent)
    : QWidget(parent),
      capture_(capture),
      sentence_(new Label({}, TextRole::kSection, Ink::kLabel)),
      connect_(makeButton(ButtonKind::kPrimary, tr("Connect a suit"), "link")),
      virtual_(makeButton(ButtonKind::kOutlined, tr("Start the virtual suit"), "play")) {
    auto* column = makeColumn(this, {32, 32, 32, 32}, 16);
    column->addStretch();
    sentence_->setAlignment(Qt::AlignHCenter);
    keepMaximumWidth(*sentence_, 520);
    auto* words = addRow(column);
    words->addStretch();
    words->addWidget(sentence_->wrapped(), 1000);
    words->addStretch();
    auto* buttons = addRow(column, 12);
    buttons->addStretch();
    virtual_->setTall(true);
    buttons->addWidget(connect_);
    buttons->addWidget(virtual_);
    buttons->addStretch();
    column->addStretch();
    connect(connect_, &QPushButton::clicked, this, [this] { capture_.shared().goTo(Step::kConnect); });
    connect(virtual_, &QPushButton::clicked, this, [this] { capture_.startVirtualSuit(); });
    connect(&capture.virtualSuit(), &VirtualSuit::changed, this, &NoSuit::refresh);
    refresh();
}

void NoSuit::refresh() {
    const VirtualSuit& suit = capture_.virtualSuit();
    const bool comes =
        suit.state() == VirtualSuit::State::kPreparing || suit.state() == VirtualSuit::State::kStarting;
    sentence_->setText(
        comes
            ? tr("The virtual suit is starting. The first time its motion is prepared, which takes a while.")
            : tr("No suit is connected. The live body, the levels of the boards and the record button "
                 "appear here as soon as one is."));
    virtual_->setDisabledBecause(comes ? tr("It is starting.")
                                 : suit.isAvailable()
                                     ? QString()
                                     : tr("noctule-virtual-suit is not beside this program."));
}

}  // namespace noctule::ui
