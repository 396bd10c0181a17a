// SPDX-License-Identifier: Apache-2.0
#include "ui/models/personal_data.h"

#include <gtest/gtest.h>

namespace noctule::ui {
namespace {

std::string without(const char* text, const QStringList& names = {}) {
    return withoutPersonalData(QString::fromUtf8(text), names).toStdString();
}

TEST(PersonalData, NamesOfEveryLanguageAreNumbered) {
    const QStringList names{"Anna Berg", "Anna", "Özil", "René", "Süß"};
    EXPECT_EQ(without("Anna Berg, Özil and René: Süß", names), "[name-0], [name-2] and [name-3]: [name-4]");
    EXPECT_EQ(without("anna_walk of Rene\xcc\x81", names), "[name-1]_walk of [name-3]");
    EXPECT_EQ(without("Annals, Süßes", names), "Annals, Süßes") << "other words";
    EXPECT_EQ(without("the “Herr Maier” was not made"), "the “[quoted]” was not made");
}

TEST(PersonalData, ThousandsOfNamesGoToo) {
    QStringList names;
    for (int i = 0; i < 5000; ++i)
        names += QStringLiteral("performance%1").arg(i);
    EXPECT_EQ(without("performance4321 and Performance7", names), "[name-4321] and [name-7]");
}

TEST(PersonalData, WholePathsGo) {
    for (const char* path :
         {"/srv/anna/walk.noctule", "/srv/anna/Klinik Sued/Herr Maier/walk.noctule",
          "/srv/anna/Klinik Sued/walk of Herr Maier.noctule", "file:///srv/anna/Klinik Sued/a.noctule",
          "C:/Users/Anna Berg/Herr O'Brien (2)/a.noctule", "~/Klinik Sued/a.noctule"}) {
        EXPECT_EQ(without((std::string(path) + " cannot be read").c_str()),
                  "[path]/*.noctule cannot be read");
        EXPECT_EQ(without((std::string("error ") + path + ": torn").c_str()), "error [path]/*.noctule: torn");
    }
    EXPECT_EQ(without("/srv/anna/Klinik Sued could not be made"), "[path]/* could not be made");
    EXPECT_EQ(without("from /srv/a b/c.bvh to /srv/d e/f.bvh"), "from [path]/*.bvh to [path]/*.bvh");
    EXPECT_EQ(without("Anna/Sued/walk.noctule, anna.berg.bvh"), "[path]/*, *.bvh");
    EXPECT_EQ(without("/srv/anna/anna.berg | Look"), "[path]/* | Look") << "no suffix of ours";
}

TEST(PersonalData, TheEndOfAKnownFolderGoesInLowerCaseToo) {
    Session session;
    session.folder = "/srv/anna/klinik sued/herr maier";
    const QString text = "/srv/anna/klinik sued/herr maier cannot be written; /srv/anna/klinik sued neither";
    const QString out = withoutPersonalData(text, namesOf(session));
    for (const char* word : {"anna", "sued", "maier", "klinik", "herr"})
        EXPECT_FALSE(out.contains(word)) << out.toStdString();
    EXPECT_TRUE(out.contains(" cannot be written")) << out.toStdString();
}

TEST(PersonalData, TheRestStays) {
    for (const char* text : {"2026-01-02T03:04:05.678Z info suit 9 is connected", "0.3 MB/s and 20 m/s",
                             "see https://example.org", "a and/or b", "Qt 5.15.8, 1280 x 800 at 1"})
        EXPECT_EQ(without(text), text);
}

}  // namespace
}  // namespace noctule::ui
