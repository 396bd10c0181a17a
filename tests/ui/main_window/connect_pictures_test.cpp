// SPDX-License-Identifier: Apache-2.0
// Pictures of Connect with a suit, well and with faults.
#include "tests/devices/support/answerer.h"
#include "tests/ui/main_window/live_pictures.h"
#include "ui/views/connect/body_map.h"
#include "ui/views/connect/connect_page.h"
#include "ui/views/connect/device_card.h"
#include "ui/views/connect/devices_panel.h"
#include "ui/views/connect/readiness_panel.h"
#include "ui/widgets/name_field.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

class ConnectPictures : public test::LivePictures {
protected:
    /// Found in the network, and while it gets a name.
    void takePicturesOfABox() {
        const noctule::test::Answerer box(noctule::test::testAnnouncement());
        studio_->finder().start({box.port(), false});
        const auto& cards = page().devices().cards();
        ASSERT_TRUE(waitFor([&] { return cards.size() == 1; }));
        save("connect-found");
        cards[0]->renameButton()->click();
        saveAs("connect-naming");
        QTest::keyClick(cards[0]->findChild<NameField*>(), Qt::Key_Escape);
    }
    ConnectPage& page() { return dynamic_cast<ConnectPage&>(window_->page(Step::kConnect)); }
};

TEST_F(ConnectPictures, WellAndWithFaults) {
    window_->goTo(Step::kConnect);
    save("connect-without");
    takePicturesOfABox();
    studio_->startVirtualSuit();
    ASSERT_TRUE(waitFor([this] { return page().readiness().verdict() == "Ready"; }));
    QTest::qWait(6000);
    save("connect-well");
    page().map().boardButton(10)->click();
    tell("unplug 18");
    tell("battery 15");
    ASSERT_TRUE(waitFor([this] { return page().readiness().verdict() == "Not ready yet"; }));
    QTest::qWait(5000);
    save("connect-faults");
    saveLarge("connect-faults");
    tell("cut 6");
    ASSERT_TRUE(waitFor([this] { return studio_->suit().status()->link == LinkState::kLost; }));
    save("connect-cut");
}

}  // namespace
}  // namespace noctule::ui
