// SPDX-License-Identifier: Apache-2.0
#include "core/report/html_report.h"

#include <gtest/gtest.h>

#include <regex>

#include "core/body/text.h"
#include "core/report/calibration_document.h"
#include "core/report/calibration_documents.h"
#include "core/report/sections.h"
#include "core/report/style.h"
#include "tests/core/report/made_report.h"

namespace noctule {
namespace {

using namespace test;

/// Empty when every tag is closed in its order; else what is wrong.
std::string tagTrouble(const std::string& page) {
    std::vector<std::string> open;
    for (size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
        const size_t end = page.find('>', at);
        if (end == std::string::npos)
            return "a tag does not end";
        const bool closes = page[at + 1] == '/', is_empty = page[end - 1] == '/' || page[at + 1] == '!';
        const size_t from = at + (closes ? 2 : 1);
        const std::string name = page.substr(from, page.find_first_of(" >/", from) - from);
        if (is_empty || name == "meta")
            continue;
        if (!closes)
            open.push_back(name);
        else if (open.empty() || open.back() != name)
            return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back()) + " at " +
                   page.substr(at > 60 ? at - 60 : 0, 80);
        else
            open.pop_back();
    }
    return open.empty() ? "" : open.back() + " stays open";
}

TEST(CalibrationDocuments, PageAndTextSayTheSame) {
    CalibrationDocument document;
    document.procedure = "Gyroscopes";
    document.summary = "17 of 18 boards";
    document.created_utc = "2026-01-02T03:04:05Z";
    document.takes = {"spin_001.noctule"};
    document.findings = {
        {Grade::kUsable, "l_hand", "Board 8, left hand: <turned> one way only", "Turn it back"}};
    document.tables = {
        {"Boards", "How to read it.", {"board", "zero, °/s"}, {{"hips", "0.0026"}, {"head", "–"}}}};
    const std::string page = calibrationHtml(document), plain = calibrationText(document);
    EXPECT_EQ(tagTrouble(page), "");
    EXPECT_TRUE(has(page, "Usable. 17 of 18 boards.") && has(plain, "Usable. 17 of 18 boards."));
    EXPECT_TRUE(has(page, "left hand: &lt;turned&gt; one way only. Turn it back."));
    EXPECT_TRUE(has(plain, "left hand: <turned> one way only. Turn it back."));
    EXPECT_TRUE(has(page, "0.0026") && has(plain, "  hips      0.0026\n  head           –\n")) << plain;
    for (const char* outside : {"<script", "http://", "url("})
        EXPECT_FALSE(has(page, outside)) << outside;
}

TEST(CalibrationDocuments, ACheckThatCouldNotBeMadeShowsNoNumbers) {
    StillCheckReport report;
    report.boards = {{.id = "hips", .heard = true, .tilt_change_rad = 0.3}, {.id = "head"}};
    report.unchecked = "gyroscopes are not calibrated";
    const CalibrationDocument unchecked = documentOf(report);
    EXPECT_EQ(unchecked.summary, "Cannot be checked: gyroscopes are not calibrated");
    EXPECT_TRUE(unchecked.numbers.empty() && unchecked.tables.empty() && !unchecked.errors);
    report.unchecked.clear();
    const CalibrationDocument checked = documentOf(report);
    ASSERT_EQ(checked.numbers.size(), 3u);
    EXPECT_EQ(checked.numbers[1].value, "–") << "no distance was heard, which is not 0 mm";
    ASSERT_EQ(checked.tables.size(), 1u);
    EXPECT_EQ(checked.tables[0].rows.size(), 1u) << "of the board that was heard";
}

TEST(CalibrationDocuments, NumbersSayHowWellScaleAndZeroAreKnown) {
    for (const CalibrationDocument& document :
         {documentOf(AccelerometerReport{}), documentOf(GyroscopeReport{})}) {
        ASSERT_GE(document.numbers.size(), 2u) << document.procedure;
        EXPECT_EQ(document.numbers[0].what, "zero known to, worst axis") << document.procedure;
        EXPECT_EQ(document.numbers[1].what, "scale known to, worst axis") << document.procedure;
    }
}

TEST(HtmlReport, IsWellFormedCompleteAndStandsAlone) {
    const std::string page = htmlReport(shortReport());
    EXPECT_EQ(tagTrouble(page), "");
    for (const char* id : {"summary", "runs", "joints", "root", "confidence", "ranges", "inertia",
                           "observability", "provenance"})
        EXPECT_TRUE(has(page, std::string("<section id=\"") + id + "\"")) << id;
    for (const char* outside : {"<script", "http://", "https://", "url(", "@import", "<img", "<link"})
        EXPECT_FALSE(has(page, outside)) << outside;
    for (const char* wrong : {"nan", "inf\"", "-inf", ">inf", "NaN"})
        EXPECT_FALSE(std::regex_search(page, std::regex(std::string("[ \">]") + wrong + "[ \"<]"))) << wrong;
}

TEST(HtmlReport, ItsPartsAreTheSameForOtherViewers) {
    const ReportData data = shortReport();
    const std::string page = htmlReport(data);
    const auto parts = reportParts(data);
    ASSERT_EQ(parts.size(), 10U);
    for (const ReportPart& part : parts) {
        if (part.id != "words")  // folded in the page
            EXPECT_NE(page.find(part.html), std::string::npos) << part.title;
        EXPECT_TRUE(part.html.starts_with("<section id=\"" + part.id + "\"")) << part.title;
    }
}

TEST(HtmlReport, HoldsTheNumbersItWasGiven) {
    const ReportData& data = shortReport();
    const std::string page = htmlReport(data);
    const Comparison& c = *data.shownRun()->comparison;
    EXPECT_TRUE(has(page, "Mean joint error " + text::degrees(c.mean_deg)));
    EXPECT_TRUE(has(page, ">" + text::number(c.find("LeftUpLeg")->angle.rms_deg, 2) + "<"));
    EXPECT_TRUE(has(page, "colspan=\"6\">Angle, degrees</th>")) << "units stand in the head";
    EXPECT_TRUE(has(page, "159.7")) << "the paper's row";
    EXPECT_TRUE(has(page, "Left foot (board 15) was clipped in 12 readings"));
    EXPECT_TRUE(has(page, "no pulses recorded"));
    EXPECT_TRUE(has(page, "Source 8 (hat), heard by left foot (board 15): mean "));
    EXPECT_TRUE(has(page, "Second round is the good one."));
    EXPECT_TRUE(has(page, "345.5 m/s"));
}

TEST(HtmlReport, SaysWhoWasEstimatedTogether) {
    ReportData data = madeReport(6);
    EXPECT_FALSE(has(htmlReport(data), " estimated together")) << "of one performer";
    EXPECT_FALSE(has(htmlReport(data), " estimated alone"));
    data.together = {"Ada", "<Bea>"};
    EXPECT_TRUE(has(htmlReport(data), ">Ada and &lt;Bea&gt; were estimated together.<"));
    data.together.push_back("Cleo");
    data.alone = {"Dan"};
    EXPECT_TRUE(has(htmlReport(data),
                    ">Ada, &lt;Bea&gt; and Cleo were estimated together. Dan was estimated alone.<"));
    data.together.clear();
    data.alone = {"Ada", "Bea"};
    EXPECT_TRUE(has(htmlReport(data), ">Ada and Bea were each estimated alone.<"));
}

TEST(HtmlReport, NamesSensorsAndFilterInWords) {
    EXPECT_TRUE(has(htmlReport(shortReport()),
                    "sensors accelerometers, gyroscopes and distances, estimator Noctule"));
}

/// Nobody meets a word of the field before it is explained: the list stands in the first part.
TEST(HtmlReport, ExplainsItsWordsBeforeTheTablesUseThem) {
    const std::string page = htmlReport(shortReport());
    const size_t words = page.find("Words of this report"), runs = page.find("<section id=\"runs\"");
    ASSERT_LT(words, runs);
    for (const char* word : {"Range", "Residual", "Estimator", "Root", "Reference", "Extended Kalman filter",
                             "Root mean square (RMS)", "NEES", "Cardan angles", "Observable"}) {
        const size_t at = page.find(">" + std::string(word) + "</dt>", words);
        EXPECT_LT(at, runs) << word;
    }
    EXPECT_LT(page.find("Noctule (manifold) is this"), runs);
    EXPECT_FALSE(has(page.substr(runs), ">manifold")) << "a name of settings";
    EXPECT_LT(page.find("A stands for accelerometers", runs), page.find("A+G+D", runs));
}

TEST(HtmlReport, WhatAProcessingMadeIsCalledAResult) {
    const std::string page = htmlReport(madeReport(6));
    EXPECT_TRUE(has(page, "Sensors and results"));
    EXPECT_TRUE(has(page, ">Result</dt>"));
    for (const char* run :
         {" run ", " runs ", " run,", " runs,", " run.", " runs.", " run<", " runs<", ">Run"})
        EXPECT_FALSE(has(page, run)) << run;
}

/// Where nothing can be folded the words stand last, and the tables come first.
TEST(HtmlReport, PartsEndWithTheWords) {
    const std::vector<ReportPart> parts = reportParts(shortReport());
    EXPECT_FALSE(has(parts.front().html, ">Estimator</dt>"));
    EXPECT_EQ(parts.back().title, "Words of this report");
    EXPECT_TRUE(has(parts.back().html, ">Estimator</dt>"));
}

TEST(HtmlReport, ShowsHowFarAnotherRunIsFromTheShownOne) {
    ReportData data = madeReport(6);
    const std::string caption = "How far other results are from the shown one";
    EXPECT_FALSE(has(htmlReport(data), caption));
    for (ReportRun& run : data.runs)
        if (&run != data.shownRun()) {
            run.name = "<other>";
            run.from_shown = data.shownRun()->comparison;
            run.from_shown->joints[0].angle.mean_deg = 7.125;
        }
    const std::string page = htmlReport(data);
    EXPECT_LT(page.find(caption), page.find("<caption>" + caption)) << "a heading to be seen, too";
    EXPECT_FALSE(has(page, ">LeftUpLeg<")) << "joints are called as in the table of joints";
    EXPECT_TRUE(has(page, "7.13") || has(page, "7.12"));
    EXPECT_FALSE(has(page, "<other>"));
}

TEST(HtmlReport, EscapesEveryName) {
    ReportData data = madeReport(6);
    const std::string evil = "<b>&\"x\"</b>";
    data.take.name = data.take.performer = data.take.file = data.take.reference_name = evil;
    data.take.notes = data.warnings = {evil};
    data.runs.back().name = data.runs.back().estimator = data.runs.back().sensors = evil;
    data.runs.back().settings = data.provenance[0].second = {{evil, evil}};
    data.runs.back().comparison->joints[2].name = data.runs.back().comparison->curves[0].name = evil;
    data.provenance[0].first = data.sources[0].label = data.boards[0].segment = data.support[0].joint = evil;
    const std::string page = htmlReport(data);
    EXPECT_FALSE(has(page, "<b>&\""));
    EXPECT_FALSE(has(page, "<b>&amp;"));
    EXPECT_TRUE(has(page, "&lt;b&gt;&amp;&quot;x&quot;&lt;/b&gt;"));
    EXPECT_EQ(tagTrouble(page), "");
}

TEST(HtmlReport, EveryJointHasItsCurvesAndNoAngleLeavesHalfATurn) {
    ReportData data = madeReport(20);
    Comparison& c = *data.runs.back().comparison;
    for (JointCurve& curve : c.curves)
        if (curve.name == "LeftUpLeg") {
            Course turning_deg;
            for (const Course::Stretch& stretch : c.mean_curve_deg.stretches())
                turning_deg.add(stretch.time_s, -60 - 12 * stretch.time_s);
            curve.estimate_deg[0] = curve.reference_deg[0] = turning_deg;
        }
    const std::string joints = jointsSection(data);
    for (const JointComparison& joint : c.joints)
        EXPECT_TRUE(
            has(joints, "<title>" + text::jointLabel(joint.name) + ", orientation difference</title>"))
            << joint.name;
    EXPECT_TRUE(has(joints, "<details><summary>Left arm</summary>"));
    const std::regex label("class=\"tick end\">[^0-9<]*([0-9]+)[^0-9.<]*<");
    int labels = 0;
    for (std::sregex_iterator at(joints.begin(), joints.end(), label), end; at != end; ++at, ++labels)
        EXPECT_LE(std::stoi((*at)[1]), 180);
    EXPECT_GT(labels, 100);

    const size_t hip = joints.find("<title>Left hip, abduction, angle Z</title>");
    ASSERT_NE(hip, std::string::npos);
    const std::string plot = joints.substr(hip, joints.find("</svg>", hip) - hip);
    const std::string curve = plot.substr(plot.rfind("<path class=\"reference\""));
    EXPECT_EQ(std::count(curve.begin(), curve.end(), 'M'), 2) << "it breaks where it goes round";
    const std::string band = plot.substr(plot.find("<path class=\"band\""));
    EXPECT_EQ(std::count(band.begin(), band.end(), 'Z'), 2) << "and so does its band";
}

TEST(HtmlReport, WhatBecameOfPulsesAddsUp) {
    const std::string page = htmlReport(shortReport());
    for (const char* column : {"Used", "Rejected", "Unused", "Hidden", "Not heard"})
        EXPECT_TRUE(has(page, std::string("<th scope=\"col\">") + column + "</th>")) << column;
}

/// Two plots beside each other are 380 px wide each, unless the page is narrower.
TEST(HtmlReport, PlotsBesideEachOtherFitAPhone) {
    EXPECT_TRUE(has(htmlReport(shortReport()), "minmax(min(380px,100%),1fr)"));
}

TEST(CalibrationDocuments, NoErrorsWithACalibrationThatNeverWas) {
    AccelerometerReport report;
    report.boards.resize(1);
    report.boards[0].positions.resize(2);
    report.boards[0].positions[0].residual_before_m_per_s2 = 0.1;
    const CalibrationDocument document = documentOf(report);
    ASSERT_TRUE(document.errors);
    EXPECT_EQ(document.errors->rows.at(0).before.size(), 1u) << "of the position that has one";
    EXPECT_EQ(document.errors->rows.at(0).after.size(), 2u);
}

TEST(HtmlReport, FewEchoesFrightenNobody) {
    ReportData data = madeReport(20);
    const std::string card = "<b>0.5 mm</b><span>range residual, median of the ranges used</span>";
    EXPECT_TRUE(has(htmlReport(data), card));
    for (ReportPair& pair : data.pairs)
        for (PulseAtBoard& pulse : pair.pulses)
            if (pulse.fate == PulseFate::kUsed) {
                pulse.residual_m = 1.5f;
                break;
            }
    EXPECT_TRUE(has(htmlReport(data), card));
}

TEST(HtmlReport, LongTakesStayBelowThreeMegabytes) {
    const size_t size = htmlReport(madeReport(300)).size();
    EXPECT_LT(size, 3'000'000u);
    EXPECT_LT(size, 2 * htmlReport(madeReport(30)).size());
}

TEST(HtmlReport, SaysWhatIsUnknownWhenAlmostNothingIs) {
    ReportData data;
    EXPECT_EQ(tagTrouble(htmlReport(data)), "");
    EXPECT_TRUE(has(htmlReport(data), "Not processed yet"));
    data = madeReport(5);
    for (ReportRun& run : data.runs)
        run.comparison.reset();
    data.support.clear();
    data.pairs.clear();
    const std::string page = htmlReport(data);
    EXPECT_EQ(tagTrouble(page), "");
    EXPECT_TRUE(has(page, "Without a reference the error of this take is not known"));
    EXPECT_TRUE(has(page, "holds no pulses"));
}

TEST(Text, NumbersAsTheStudioWritesThem) {
    EXPECT_EQ(text::number(-1.25, 1), "−1.2");
    EXPECT_EQ(text::number(-0.001, 1), "0.0");
    EXPECT_EQ(text::number(NAN, 1), "–");
    EXPECT_EQ(text::count(1234567), "1\u202F234\u202F567");
    EXPECT_EQ(text::percent(0.9996), "99.9 %");
    EXPECT_EQ(text::percent(1), "100 %");
    EXPECT_EQ(text::percent(0.0001), "0.1 %");
    EXPECT_EQ(text::clock(3725), "1:02:05");
    EXPECT_EQ(text::clock(17.4), "0:17");
    EXPECT_EQ(text::jointLabel("LeftForeArm"), "Left elbow");
    EXPECT_EQ(text::jointLabel("Tail_01"), "Tail_01");
    EXPECT_EQ(text::segmentLabel("RightUpLeg"), "right thigh");
    EXPECT_EQ(text::utc("2026-11-21T09:58:00Z"), "2026-11-21 09:58 UTC");
    EXPECT_EQ(text::escaped("a<b>\"&\n"), "a&lt;b&gt;&quot;&amp; ");
    EXPECT_EQ(confidenceClass(NAN), "c0");
    EXPECT_EQ(confidenceClass(2), "c20");
}

}  // namespace
}  // namespace noctule
