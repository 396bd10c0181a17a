// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <regex>

#include "core/body/text.h"
#include "core/report/calibration_document.h"
#include "core/report/calibration_documents.h"
#include "core/report/evaluation_json.h"
#include "core/report/html_report.h"
#include "core/report/joint_support.h"
#include "core/report/range_statistics.h"
#include "core/report/sections.h"
#include "core/report/style.h"
#include "core/report/svg_plot.h"
#include "core/report/verdict.h"
#include "tests/core/report/made_report.h"

namespace noctule {
namespace {

using namespace test;

const ReportData& shortReport() {
    static const ReportData data = madeReport(20);
    return data;
}

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

bool has(const std::string& page, const std::string& part) {
    return page.find(part) != std::string::npos;
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

/// Where nothing can be folded the words stand last, and the tables come first.
TEST(HtmlReport, PartsEndWithTheWords) {
    const std::vector<ReportPart> parts = reportParts(shortReport());
    EXPECT_FALSE(has(parts.front().html, ">Estimator</dt>"));
    EXPECT_EQ(parts.back().title, "Words of this report");
    EXPECT_TRUE(has(parts.back().html, ">Estimator</dt>"));
}

TEST(HtmlReport, ShowsHowFarAnotherRunIsFromTheShownOne) {
    ReportData data = madeReport(6);
    const std::string caption = "How far other runs are from the shown run";
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

TEST(EvaluationJson, HasTheDocumentedMembers) {
    const ReportData& data = shortReport();
    const nlohmann::json json = evaluationJson(data, *data.shownRun());
    EXPECT_EQ(json.at("take"), "boxer_001");
    EXPECT_EQ(json.at("run"), "AGD-manifold");
    EXPECT_EQ(json.at("sensors"), "AGD");
    EXPECT_EQ(json.at("joints").size(), 17u);
    const Comparison& c = *data.shownRun()->comparison;
    EXPECT_EQ(json.at("joints")[0].at("name"), c.joints[0].name);
    for (const char* member : {"mean_deg", "std_deg", "rms_deg"})
        EXPECT_TRUE(json.at("joints")[0].at(member).is_number()) << member;
    EXPECT_DOUBLE_EQ(json.at("mean_deg"), c.mean_deg);
    for (const char* member : {"end_effector_mm", "nees", "duration_s"})
        EXPECT_TRUE(json.at(member).is_number()) << member;
    for (const char* member : {"yaw_deg", "tilt_deg", "position_m"})
        EXPECT_TRUE(json.at("root").at(member).is_number()) << member;
    EXPECT_EQ(json.at("verdict"), "Usable") << "a board lost frames";
    EXPECT_NO_THROW((void)json.dump());
}

TEST(EvaluationJson, UnknownIsNullAndNeverNan) {
    ReportData data = madeReport(5);
    data.runs.back().comparison->nees.reset();
    data.runs.back().comparison->joints[0].angle.mean_deg = NAN;
    const nlohmann::json json = evaluationJson(data, data.runs.back());
    EXPECT_TRUE(json.at("nees").is_null());
    EXPECT_TRUE(json.at("joints")[0].at("mean_deg").is_null());
    data.runs.back().comparison.reset();
    const nlohmann::json without = evaluationJson(data, data.runs.back());
    EXPECT_TRUE(without.at("mean_deg").is_null());
    EXPECT_TRUE(without.at("root").at("yaw_deg").is_null());
    EXPECT_TRUE(without.at("joints").empty());
}

TEST(Verdict, FollowsTheError) {
    ReportData data = madeReport(5);
    for (size_t i = 0; i < data.boards.size(); ++i)
        data.boards[i].frames_lost = data.boards[i].clipped_accel = 0;
    data.boards[14].readings_present = data.boards[14].readings_expected;
    const auto gradeAt = [&](double mean_deg) {
        data.runs.back().comparison->mean_deg = mean_deg;
        return judge(data).grade;
    };
    EXPECT_EQ(gradeAt(1), Grade::kGood);
    EXPECT_EQ(gradeAt(5), Grade::kUsable);
    EXPECT_EQ(gradeAt(12), Grade::kNotUsable);
    EXPECT_EQ(gradeAt(NAN), Grade::kNotUsable);
    EXPECT_EQ(gradeAt(1), Grade::kGood);
    data.runs.back().comparison->joints[3].angle.mean_deg = 20;
    EXPECT_EQ(judge(data).grade, Grade::kUsable);
    data.boards[2].readings_present = 0;
    EXPECT_TRUE(has(judge(data).reasons.back(), "Chest (board 3) delivered 0 %"));
    data.take.reference_kind = "optical";
    EXPECT_TRUE(has(judge(data).headline, "against the optical reference"));
}

TEST(RangeStatistics, CountsFatesAndGaps) {
    ReportPair pair{0, 0, {}};
    const PulseFate fates[] = {PulseFate::kUsed,    PulseFate::kRejected, PulseFate::kOccluded,
                               PulseFate::kMissing, PulseFate::kUsed,     PulseFate::kUnused};
    for (int i = 0; i < 6; ++i)
        pair.pulses.push_back(
            {static_cast<float>(i), fates[i], i == 0 ? 0.5f : 1.0f, 1.0f, i == 0 ? 0.003f : 0.004f});
    const RangeStatistics s = rangeStatistics(pair);
    EXPECT_EQ(s.pulses(), 6);
    EXPECT_EQ(s.heard(), 4);
    EXPECT_EQ(s.of(PulseFate::kUsed), 2);
    EXPECT_DOUBLE_EQ(s.longest_gap_s, 4);
    EXPECT_NEAR(*s.residualRms_m(), 0.0035355, 1e-6);
    EXPECT_NEAR(s.meanConfidence(), 5.5 / 6, 1e-9);
    EXPECT_FALSE(rangeStatistics(ReportPair{}).residualRms_m());
}

TEST(JointSupport, ARangeBacksTheJointsBetweenItsEnds) {
    Suit suit;
    suit.boards = {{"l_hand", "", "LeftHand"}, {"head", "", "Head"}};
    suit.sources = {{"s1", "", "Chest"}, {"s2", "", "Hips"}};
    ReportPair pair{0, 0, {}};  // chest to left hand, used in the first half of ten seconds
    for (int i = 0; i < 10; ++i)
        pair.pulses.push_back({0.5f * static_cast<float>(i), PulseFate::kUsed, 1, 1, 0});
    ReportTake take;
    take.duration_s = 10;
    auto support = jointSupport(defaultActor().skeleton, suit, {pair}, {1.0, 0.5}, take, 0.6);
    const auto of = [&](const std::string& name) {
        return *std::find_if(support.begin(), support.end(),
                             [&](const JointSupport& s) { return s.joint == name; });
    };
    for (const char* joint : {"LeftShoulder", "LeftArm", "LeftForeArm", "LeftHand"}) {
        EXPECT_NEAR(of(joint).ranges, 0.51, 0.01) << joint;
        EXPECT_NEAR(of(joint).inertia, 0.49, 0.01) << joint;
    }
    EXPECT_EQ(of("Chest").ranges, 0) << "both ends turn with the chest";
    EXPECT_EQ(of("Head").ranges, 0);
    EXPECT_EQ(of("Head").inertia, 0.5);
    EXPECT_EQ(of("Spine").inertia, 1);
    EXPECT_EQ(of("RightArm").alone(), 1);
    EXPECT_EQ(support.size(), 17u);

    take.begin_s = 3;  // another box began first
    for (PulseAtBoard& pulse : pair.pulses)
        pulse.time_s += 3;
    support = jointSupport(defaultActor().skeleton, suit, {pair}, {1.0, 0.5}, take, 0.6);
    EXPECT_NEAR(of("LeftArm").ranges, 0.51, 0.01);
    EXPECT_NEAR(of("LeftArm").lost_from_s.value_or(0), 3 + 5.1, 0.1);
}

TEST(JointSupport, TheRestPoseAtTheBeginningDoesNotCount) {
    Suit suit;
    suit.boards = {{"l_hand", "", "LeftHand"}};
    suit.sources = {{"s1", "", "Chest"}};
    ReportPair pair{0, 0, {}};
    for (int i = 0; i < 75; ++i)  // no range is used while the rest pose is measured
        pair.pulses.push_back(
            {0.1f * static_cast<float>(i), i < 52 ? PulseFate::kRejected : PulseFate::kUsed, 1, 1, 0});
    ReportTake take;
    take.duration_s = 7.5;
    take.rest_s = 5.2;
    const auto shareOfHand = [&] {
        const auto support = jointSupport(defaultActor().skeleton, suit, {pair}, {1.0}, take);
        return std::ranges::find(support, "LeftHand", &JointSupport::joint)->ranges;
    };
    EXPECT_NEAR(shareOfHand(), 1, 0.06);

    take.begin_s = 3;  // another box began first; the rest is on the take's clock
    take.rest_s += 3;
    for (PulseAtBoard& pulse : pair.pulses)
        pulse.time_s += 3;
    EXPECT_NEAR(shareOfHand(), 1, 0.06);

    take.rest_s = take.end_s() + 1;
    EXPECT_EQ(shareOfHand(), 0);
}

TEST(SvgPlot, DecimationKeepsExtremesAndBreaksAtHoles) {
    std::vector<double> time_s, values;
    for (int i = 0; i < 100000; ++i) {
        time_s.push_back(i * 0.001 + (i > 50000 ? 5 : 0));
        values.push_back(i == 20000 ? 10 : i % 2 ? 1.0 : -1.0);
    }
    values[70000] = NAN;
    const std::string path = decimatedPath(time_s, values, {0, 105}, {-10, 10}, {0, 500}, {0, 100});
    EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 3);
    EXPECT_TRUE(has(path, " 0 ")) << "the single spike reaches the top";
    EXPECT_LT(path.size(), 16000u);
    EXPECT_FALSE(std::regex_search(path, std::regex("[^-M0-9. ]")));
}

TEST(SvgPlot, ABandBreaksWhereItsCurveBreaks) {
    std::vector<double> time_s, middle, half_width(600, 5);
    for (int i = 0; i < 600; ++i) {
        time_s.push_back(0.02 * i + (i < 400 ? 0 : 2));  // a hole of two seconds
        middle.push_back(i < 200 ? 170 : -170);
    }
    middle[200] = NAN;  // it goes round
    LinePlot plot;
    plot.time_s = {0, 14};
    plot.values = {-180, 180};
    plot.bands.push_back({time_s, middle, half_width});
    std::string band = svg(plot);
    band = band.substr(band.find("<path class=\"band\" d=\""));
    band = band.substr(0, band.find("/>"));
    EXPECT_EQ(std::count(band.begin(), band.end(), 'M'), 3);
    EXPECT_EQ(std::count(band.begin(), band.end(), 'Z'), 3);
    half_width[450] = INFINITY;
    EXPECT_EQ(std::ranges::count(svg(plot), 'Z'), 4) << "nothing is known of one instant";
}

TEST(SvgPlot, TicksAreRoundAndFew) {
    const std::vector<double> tens = ticks({-5, 42}, 5);
    EXPECT_EQ(tens, (std::vector<double>{0, 10, 20, 30, 40}));
    for (const double top : {0.03, 0.7, 1.0, 3.3, 17.0, 99.0, 1234.0}) {
        const std::vector<double> values = ticks({0, top}, 5);
        EXPECT_GE(values.size(), 2u) << top;
        EXPECT_LE(values.size(), 6u) << top;
    }
    EXPECT_TRUE(ticks({1, 1}, 5).empty());
    const std::vector<double> nothing = {NAN, INFINITY};
    EXPECT_EQ(niceInterval({nothing}, 2).span(), 2);
    const std::vector<double> some = {-3.2, 14.1};
    EXPECT_LE(niceInterval({some}, 1).min, -3.2);
    EXPECT_GE(niceInterval({some}, 1).max, 14.1);
    EXPECT_LE(timeTicks({0, 307}).size(), 11u);
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
