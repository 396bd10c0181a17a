// SPDX-License-Identifier: Apache-2.0
// The Export page of a session whose take is open.
#pragma once

#include "tests/ui/views/reviewed_session.h"
#include "ui/views/export/export_form.h"
#include "ui/views/export/export_page.h"
#include "ui/views/export/export_results_panel.h"
#include "ui/widgets/button.h"

namespace noctule::ui::test {

class ExportPageTest : public ReviewedSession {
protected:
    void SetUp() override {
        ReviewedSession::SetUp();
        if (HasFatalFailure())
            return;
        openTake("swing_001");
        page_ = std::make_unique<ExportPage>(*studio_);
        page_->resize(1000, 700);
        page_->show();
        page_->choosePreset("bvh");
        page_->enter();
    }
    void TearDown() override {
        waitFor([this] { return jobsAreDone(); });
        page_.reset();
        ReviewedSession::TearDown();
    }

    void write() {
        QTest::mouseClick(page_->writeButton(), Qt::LeftButton);
        ASSERT_TRUE(waitFor([this] { return page_->results().has_value() && jobsAreDone(); }));
    }
    std::string exported(const char* name) const {
        return (studio_->session().session().exportsFolder() / name).string();
    }

    std::unique_ptr<ExportPage> page_;
};

}  // namespace noctule::ui::test
