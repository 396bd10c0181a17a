// SPDX-License-Identifier: Apache-2.0
// An export finds a damaged take: it is told of which, and what can be read of it may be saved.
#include <QCheckBox>
#include <QSignalSpy>

#include "tests/core/simulation/swaying_pair.h"
#include "tests/support/take_files.h"
#include "tests/ui/views/reviewed_session.h"
#include "ui/views/export/export_form.h"
#include "ui/views/export/export_page.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

class ExportDamageTest : public test::ReviewedSession {
protected:
    /// The takes that the operator is told are damaged.
    QStringList toldOf(ExportPage& page) {
        const QSignalSpy torn(studio_.get(), &Studio::tornTake);
        QTest::mouseClick(page.writeButton(), Qt::LeftButton);
        EXPECT_TRUE(waitFor([&] { return page.results().has_value() && jobsAreDone(); }));
        QStringList takes;
        for (const auto& told : torn)
            takes += told[0].toString();
        return takes;
    }
};

TEST_F(ExportDamageTest, OfTakesInOneFileTheDamagedOneIsNamed) {
    addTake("kick_002");
    openTake("swing_001");
    noctule::test::damageRowsOf(takePath("kick_002").toStdString(), "pose");
    ExportPage page(*studio_);
    page.show();
    page.choosePreset("blender");
    page.form().setTakes({"swing_001", "kick_002"});
    page.form().one_file->setChecked(true);
    EXPECT_EQ(toldOf(page), QStringList{takePath("kick_002")});
    ASSERT_EQ(page.results()->outcomes.size(), 1U);
    EXPECT_EQ(page.results()->outcomes[0].take, "kick_002");
    EXPECT_EQ(page.results()->written(), 0);
}

TEST_F(ExportDamageTest, ATakeOfSeveralPeopleIsNamed) {
    const std::string pair = outsideFile("pair.noctule").toStdString();
    const Status written = noctule::test::writeProcessedPair(pair);
    ASSERT_TRUE(written) << written.error().text();
    studio_->session().importTakes({QString::fromStdString(pair)});
    ASSERT_TRUE(waitFor([this] { return studio_->session().session().takes.size() == 2 && jobsAreDone(); }));
    noctule::test::damageRowsOf(takePath("pair").toStdString(), "pose");
    ExportPage page(*studio_);
    page.show();
    page.choosePreset("blender");
    page.form().setTakes({"pair"});
    page.form().one_file->setChecked(true);
    EXPECT_EQ(toldOf(page), QStringList{takePath("pair")});
}

}  // namespace
}  // namespace noctule::ui
