// SPDX-License-Identifier: Apache-2.0
// Pictures of Connect with a suit, well and with faults.
#include "tests/ui/main_window/live_pictures.h"
#include "ui/views/body_map.h"
#include "ui/views/connect_page.h"
#include "ui/views/readiness_panel.h"

namespace noctule::ui {
namespace {

class ConnectPictures : public test::LivePictures {
protected:
    ConnectPage& page() { return dynamic_cast<ConnectPage&>(window_->page(Step::kConnect)); }
};

TEST_F(ConnectPictures, WellAndWithFaults) {
    window_->goTo(Step::kConnect);
    save("connect-without");
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
