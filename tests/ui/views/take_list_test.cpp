// SPDX-License-Identifier: Apache-2.0
#include "ui/views/take_list.h"

#include "tests/ui/views/reviewed_session.h"
#include "ui/style/theme.h"
#include "ui/views/take_delegate.h"

namespace noctule::ui {
namespace {

class TakeListTest : public test::ReviewedSession {
protected:
    void SetUp() override {
        ReviewedSession::SetUp();
        if (HasFatalFailure())
            return;
        addTake("swing_002");
        openTake("swing_001");
        takes_ = std::make_unique<TakeList>(*studio_);
        takes_->resize(248, 200);
        takes_->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(takes_.get()));
    }
    void TearDown() override {
        takes_.reset();
        ReviewedSession::TearDown();
    }
    const SessionTake& take(const char* name) const {
        const Session& session = studio_->session().session();
        return session.takes[static_cast<size_t>(session.findTake(name))];
    }
    QRect rowOf(const char* name) const {
        return takes_->visualRect(takes_->model()->index(studio_->session().session().findTake(name), 0));
    }
    /// Where the stars of a row stand for this rating.
    static QPoint starOf(const QRect& row, int rating) {
        for (QPoint at(row.left(), row.center().y()); at.x() <= row.right(); ++at.rx())
            if (TakeDelegate::ratingAt(row, at) == rating)
                return at + QPoint(Theme::get().px(4), 0);
        return {};
    }

    std::unique_ptr<TakeList> takes_;
};

TEST_F(TakeListTest, AClickOpensATakeAndOneOnItsStarsRatesIt) {
    const QRect row = rowOf("swing_002");
    QTest::mouseClick(takes_->viewport(), Qt::LeftButton, {}, starOf(row, 4));
    EXPECT_EQ(take("swing_002").rating, 4);
    QTest::qWait(100);
    EXPECT_EQ(studio_->take().path(), takePath("swing_001")) << "a rating opens nothing";
    QTest::mouseClick(takes_->viewport(), Qt::LeftButton, {},
                      QPoint(row.left() + Theme::get().px(40), row.center().y()));
    EXPECT_TRUE(waitFor([this] { return studio_->take().path() == takePath("swing_002"); }));
    EXPECT_EQ(take("swing_002").rating, 4);
}

TEST_F(TakeListTest, TheHighlightedTakeIsTheOpenOne) {
    const auto highlighted = [this] {
        const QModelIndexList rows = takes_->selectionModel()->selectedIndexes();
        return rows.size() == 1 ? takes_->model()->data(rows[0], TakeListModel::kName).toString() : QString();
    };
    ASSERT_EQ(highlighted(), "swing_001");
    QTest::mouseClick(takes_->viewport(), Qt::LeftButton, {}, starOf(rowOf("swing_002"), 3));
    EXPECT_EQ(take("swing_002").rating, 3);
    EXPECT_EQ(highlighted(), "swing_001") << "stars choose no take";
    const bool is_above = studio_->session().session().findTake("swing_002") <
                          studio_->session().session().findTake("swing_001");
    QTest::keyClick(takes_.get(), is_above ? Qt::Key_Up : Qt::Key_Down);
    EXPECT_TRUE(waitFor([this] { return studio_->take().path() == takePath("swing_002"); }));
    EXPECT_EQ(highlighted(), "swing_002");
}

}  // namespace
}  // namespace noctule::ui
