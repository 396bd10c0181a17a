// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/pages.h"

#include <stdexcept>

#include "ui/robot/robot_page.h"
#include "ui/views/connect/connect_page.h"
#include "ui/views/export/export_page.h"
#include "ui/views/performer/performer_page.h"
#include "ui/views/record/record_page.h"
#include "ui/views/review/review_page.h"
#include "ui/views/session/start_page.h"
#include "ui/wizards/calibrate_page.h"

namespace noctule::ui {

Page* makePageFor(Step step, Studio& studio, RecentSessions& recent, RobotDrive& robot) {
    switch (step) {
        case Step::kStart:
            return new StartPage(studio, recent);
        case Step::kConnect:
            return new ConnectPage(studio);
        case Step::kCalibrate:
            return new CalibratePage(studio);
        case Step::kRecord:
            return new RecordPage(studio);
        case Step::kReview:
            return new ReviewPage(studio);
        case Step::kExport:
            return new ExportPage(studio);
        case Step::kPerformer:
            return new PerformerPage(studio);
        case Step::kRobot:
            return new RobotPage(studio, robot);
    }
    throw std::logic_error("every step has a page");
}

}  // namespace noctule::ui
