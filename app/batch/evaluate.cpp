// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "app/batch/files.h"
#include "app/batch/motion_file.h"
#include "app/batch/verb.h"
#include "core/body/text.h"
#include "core/job/atomic_file.h"
#include "core/job/outside_text.h"
#include "core/math/json.h"
#include "core/processing/evaluate_between.h"
#include "core/processing/evaluate_points.h"
#include "core/processing/evaluate_take.h"
#include "core/processing/orient_take.h"
#include "core/processing/root_in_world.h"
#include "core/processing/run_subjects.h"
#include "core/report/evaluation_json.h"
#include "core/report/html_report.h"
#include "core/report/joints_csv.h"
#include "core/report/verdict.h"

namespace noctule::batch {
namespace {

constexpr size_t kJointName = 40;  ///< bytes in a table

std::string jointRow(const std::string& name, const std::string& mean, const std::string& deviation,
                     const std::string& rms) {
    char row[160];
    std::snprintf(row, sizeof row, "%-20s %10s %10s %10s\n", shortText(name, kJointName).c_str(),
                  mean.c_str(), deviation.c_str(), rms.c_str());
    return row;
}

std::string fixed(double value, int decimals = 2) {
    char text[48];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string comparisonText(const Comparison& c) {
    std::string text = jointRow("joint", "mean deg", "std deg", "rms deg");
    for (const JointComparison& joint : c.joints)
        text += jointRow(joint.name, fixed(joint.angle.mean_deg), fixed(joint.angle.std_deg),
                         fixed(joint.angle.rms_deg));
    char mean[48];
    std::snprintf(mean, sizeof mean, "%-20s %10s\n", "mean", fixed(c.mean_deg).c_str());
    text += mean;
    if (c.end_effector_mm)
        text += "hands, feet, head     " + fixed(*c.end_effector_mm, 1) + " mm off in the hips' frame\n";
    text += "root                  yaw " + fixed(c.root.yaw_deg) + " deg, tilt " + fixed(c.root.tilt_deg) +
            " deg, position " + fixed(c.root.position_m, 3) + " m (rms, start taken off)\n";
    if (c.nees)
        text += "NEES                  " + fixed(*c.nees) + " (1: as sure as it may be)\n";
    return text + "compared              " + fixed(c.duration_s, 1) + " s, " + std::to_string(c.frames) +
           " poses\n";
}

const char* wordOf(FrameFrom from) {
    return from == FrameFrom::kSame ? "same" : from == FrameFrom::kZeroPose ? "rest pose" : "motion";
}

nlohmann::json matchedJson(const Comparison& comparison) {
    nlohmann::json joints = nlohmann::json::array();
    for (const MatchedJoint& joint : comparison.matched)
        joints.push_back({{"joint", joint.name},
                          {"reference_joint", joint.reference_name},
                          {"moves", joint.moves},
                          {"axes_from", wordOf(joint.segment.from)},
                          {"taken_off_deg", degrees(joint.segment.taken_off_rad)}});
    return joints;
}

/// Joints that the reference calls otherwise.
std::string matchedText(const Comparison& comparison) {
    std::string text;
    for (const MatchedJoint& joint : comparison.matched)
        if (joint.name != joint.reference_name)
            text += (text.empty() ? "" : ", ") + joint.name + " = " + joint.reference_name;
    return text.empty() ? "" : "joints matched        " + text + "\n";
}

std::string verdictText(const Verdict& verdict) {
    std::string text = verdict.headline + "\n";
    for (const std::string& reason : verdict.reasons)
        text += "  " + reason + "\n";
    return text;
}

std::string evaluationText(const ReportData& data, const ReportRun& run) {
    std::string text = data.take.name + ", result " + run.name + ": sensors " + run.sensors + ", estimator " +
                       run.estimator + ", root " + (run.root_given ? "given" : "free") + "\n";
    if (run.comparison)
        text += comparisonText(*run.comparison) + matchedText(*run.comparison);
    return text + verdictText(judge(data));
}

Outcome orientationOutcome(const std::string& take, const OrientationEvaluation& evaluation) {
    const OrientationScore& score = evaluation.score;
    const auto angle = [](const char* name, double deg) {
        return std::string(name) + fixed(deg) + " deg rms\n";
    };
    return {{{"take", take},
             {"run", evaluation.run_name},
             {"board", evaluation.board},
             {"total_deg", score.total_deg},
             {"heading_deg", score.heading_deg},
             {"inclination_deg", score.inclination_deg},
             {"heading_offset_deg", score.heading_offset_deg},
             {"total_turned_deg", score.total_turned_deg},
             {"heading_turned_deg", score.heading_turned_deg},
             {"readings", score.samples}},
            takeName(take) + ", result " + evaluation.run_name + ", sensor " + evaluation.board + "\n" +
                angle("total                 ", score.total_deg) +
                angle("heading               ", score.heading_deg) +
                angle("inclination           ", score.inclination_deg) + "north differs by      " +
                fixed(score.heading_offset_deg) + " deg; with that taken off:\n" +
                angle("  total               ", score.total_turned_deg) +
                angle("  heading             ", score.heading_turned_deg) + "compared              " +
                std::to_string(score.samples) + " readings in movement\n",
            std::nullopt};
}

/// Where the subjects are to each other; nothing where a reference lacks.
Status addBetween(const VerbContext& context, const EvaluateRequest& request,
                  const std::vector<TakeSubject>& subjects, Outcome& outcome) {
    if (request.reference)
        return Done{};
    const auto between = evaluateBetween(request, subjects, context.job());
    if (!between)
        return between.error();
    for (const BetweenEvaluation& pair : *between) {
        if (!pair.observed) {
            outcome.json["between"].push_back({{"a", pair.a}, {"b", pair.b}, {"observed", false}});
            outcome.text += "between " + pair.a + " and " + pair.b +
                            ": not observed. Nothing measured where they stand to each other, distances "
                            "between them mean nothing\n";
            continue;
        }
        outcome.json["between"].push_back({{"a", pair.a},
                                           {"b", pair.b},
                                           {"observed", true},
                                           {"from", pair.from},
                                           {"to", pair.to},
                                           {"rms_mm", pair.rms_mm},
                                           {"rms_near_mm", json::orNull(pair.rms_near_mm)},
                                           {"rms_world_mm", pair.rms_world_mm},
                                           {"sigma_mm", json::orNull(pair.sigma_mm)},
                                           {"nees", json::orNull(pair.nees)},
                                           {"heading_deg", pair.heading_deg}});
        outcome.text +=
            "between " + pair.a + " " + pair.from + " and " + pair.b + " " + pair.to + ": " +
            fixed(pair.rms_mm, 1) + " mm rms" +
            (pair.rms_near_mm ? ", " + fixed(*pair.rms_near_mm, 1) + " mm when nearer than 0.3 m"
                              : std::string()) +
            "; relative heading " + fixed(pair.heading_deg) + " deg" +
            (pair.sigma_mm ? "; stated " + fixed(*pair.sigma_mm, 1) + " mm, NEES " + fixed(*pair.nees)
                           : std::string()) +
            "\n";
    }
    return Done{};
}

/// How a subject stands in the room, where anchors hold it there: into `json`, and as the end of a line.
Result<std::string> addInRoom(const VerbContext& context, const EvaluateRequest& request,
                              const TakeSubject& subject, nlohmann::json& json) {
    const auto in_world = rootInWorld(request.take_path, request.run, subject, context.job());
    if (!in_world)
        return in_world.error();
    if (!*in_world)
        return std::string();
    json["root_in_world"] = {{"position_m", (*in_world)->position_m}, {"yaw_deg", (*in_world)->yaw_deg}};
    return "as it stands in the room " + fixed((*in_world)->position_m, 4) + " m, yaw " +
           fixed((*in_world)->yaw_deg) + " deg";
}

/// Of several performers the worst one's verdict is that of the take; each has its own in `subjects`.
void addWorstVerdict(const std::vector<SubjectReport>& reports, Outcome& outcome) {
    Grade worst = Grade::kGood;
    std::vector<Grade> grades;
    for (const SubjectReport& report : reports) {
        grades.push_back(judge(report.data).grade);
        worst = std::max(worst, grades.back());
    }
    std::string names;
    for (size_t i = 0; i < reports.size(); ++i)
        if (grades[i] == worst)
            names += (names.empty() ? "" : ", ") + reports[i].subject;
    outcome.json["verdict"] = gradeName(worst);
    nlohmann::json reasons = nlohmann::json::array();
    for (const nlohmann::json& subject : outcome.json["subjects"])
        for (const nlohmann::json& reason : subject["reasons"])
            reasons.push_back(subject["name"].get<std::string>() + ": " + reason.get<std::string>());
    outcome.json["reasons"] = reasons;
    const bool apart =
        std::ranges::any_of(reports, [](const SubjectReport& report) { return report.data.people_apart; });
    outcome.text =
        "all subjects: " + gradeName(worst) + (worst > Grade::kGood ? " (" + names + ")" : "") +
        (apart ? ", each alone; distances between them mean nothing where they were not observed" : "") +
        "\n" + outcome.text;
}

/// One entry of `subjects` and some lines each; the rest of the outcome but the verdict is the first
/// subject's. `reports`: of the shown run, each subject's.
Status addSubjects(const VerbContext& context, EvaluateRequest request,
                   const std::vector<TakeSubject>& subjects, Outcome& outcome,
                   std::vector<SubjectReport>& reports) {
    request.all_runs = false;
    outcome.json["subject"] = subjects.front().name;
    outcome.text =
        "subject " + subjects.front().name + ", of " + std::to_string(subjects.size()) + "\n" + outcome.text;
    for (const TakeSubject& subject : subjects) {
        request.suit = subject.suit();
        auto data = evaluateTake(request, context.job());
        if (!data)
            return data.error();
        const nlohmann::json all = evaluationJson(*data, *data->shownRun());
        nlohmann::json own{{"name", subject.name}, {"suit", subject.suit()}};
        for (const char* member :
             {"mean_deg", "end_effector_mm", "root", "nees", "duration_s", "verdict", "reasons"})
            own[member] = all.value(member, nlohmann::json(nullptr));
        own["root_in_world"] = nullptr;
        const auto in_room = addInRoom(context, request, subject, own);
        if (!in_room)
            return in_room.error();
        outcome.json["subjects"].push_back(own);
        const auto& comparison = data->shownRun()->comparison;
        outcome.text += "subject " + subject.name + ": " +
                        (comparison ? fixed(comparison->mean_deg) + " deg mean, root position " +
                                          fixed(comparison->root.position_m, 3) + " m"
                                    : std::string("no reference")) +
                        (in_room->empty() ? "" : "; " + *in_room) + "\n";
        data->take.performer = subject.name;
        if (&subject != &subjects.front())  // the first one's stands above
            outcome.text += verdictText(judge(*data));
        reports.push_back({subject.name, std::move(*data)});
    }
    addWorstVerdict(reports, outcome);
    return Done{};
}

Status writeEvaluationPage(const VerbContext& context, const std::string& path, const std::string& html,
                           Outcome& outcome) {
    if (Status written = writeFileAtomically(path, html, context.arguments.given("overwrite")); !written)
        return written;
    outcome.json["report"] = path;
    outcome.text += "report                " + path + "\n";
    return Done{};
}

/// The first performer's page is at `path`, those of the others are beside it.
Status writeOtherPages(const VerbContext& context, const std::string& path,
                       const std::vector<SubjectReport>& reports, Outcome& outcome) {
    for (size_t i = 1; i < reports.size(); ++i) {
        const auto& [subject, data] = reports[i];
        const std::string own_path = pathOfSubject(path, subject);
        if (Status written =
                writeFileAtomically(own_path, htmlReport(data), context.arguments.given("overwrite"));
            !written)
            return written;
        outcome.json["reports_of_others"].push_back(own_path);
        outcome.text += "report of " + subject + ", " + own_path + "\n";
    }
    return Done{};
}

/// Tables of points against the take's reference.
Result<Outcome> runEvaluatePoints(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    for (const char* name : {"run", "reference", "csv"})
        if (arguments.given(name))
            return Error{ErrorKind::kUsage,
                         "--" + std::string(name) +
                             " does not go with --points, which are compared with the take's own reference",
                         "Leave it out"};
    const std::string take = arguments.operands()[0], report_path = arguments.text("report");
    const std::vector<std::string> tables = arguments.texts("points");
    if (Status free = checkOutputs(arguments, {"report"}); !free)
        return free.error();
    std::vector<PointsEvaluation> all;
    Outcome outcome;
    outcome.json = {{"take", take}};
    for (const std::string& path : tables) {
        const auto table = readPointsTable(path);
        if (!table)
            return table.error();
        auto found = evaluatePoints(take, *table, context.job());
        if (!found)
            return found.error();
        nlohmann::json points = nlohmann::json::array();
        for (const PointEvaluation& point : found->points)
            points.push_back(
                {{"subject", point.subject}, {"device", point.device}, {"rms_mm", point.rms_mm}});
        outcome.json["tables"].push_back({{"points", path},
                                          {"rms_mm", found->rms_mm},
                                          {"between_rms_mm", json::orNull(found->between_rms_mm)},
                                          {"between_near_rms_mm", json::orNull(found->between_near_rms_mm)},
                                          {"nees", json::orNull(found->nees)},
                                          {"instants", found->instants},
                                          {"devices", points}});
        outcome.text +=
            path + ": " + fixed(found->rms_mm, 1) + " mm rms over " + std::to_string(found->points.size()) +
            " points" +
            (found->between_rms_mm ? ", " + fixed(*found->between_rms_mm, 1) + " mm between subjects"
                                   : std::string()) +
            (found->nees ? "; NEES " + fixed(*found->nees)
                         : "; the common place and turn were not observed: there are no anchors") +
            "\n";
        all.push_back(std::move(*found));
    }
    if (!report_path.empty())
        if (Status written =
                writeEvaluationPage(context, report_path, pointsReport(takeName(take), tables, all), outcome);
            !written)
            return written.error();
    return outcome;
}

Result<Outcome> runEvaluate(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    if (arguments.given("points"))
        return runEvaluatePoints(context);
    const bool overwrite = arguments.given("overwrite");
    const std::string report_path = arguments.text("report");
    const std::string csv_path = arguments.text("csv");
    if (Status free = checkOutputs(arguments, {"report", "csv"}); !free)
        return free.error();
    const auto oriented = evaluateOrientation(arguments.operands()[0], arguments.text("run"));
    if (!oriented)
        return oriented.error();
    if (*oriented)
        return orientationOutcome(arguments.operands()[0], **oriented);
    EvaluateRequest request;
    request.take_path = arguments.operands()[0];
    request.run = arguments.text("run");
    request.all_runs = !report_path.empty() || !csv_path.empty();
    request.reference_name = arguments.text("reference");
    nlohmann::json understood;
    if (Status fits = checkMotionOptions(arguments, "reference"); !fits)
        return fits.error();
    if (arguments.given("reference")) {
        auto motion = readReference(request.reference_name, arguments, context.console, understood);
        if (!motion)
            return motion.error();
        request.reference = std::move(*motion);
    }
    const auto subjects = subjectsOfRun(request.take_path, request.run);
    if (!subjects)
        return subjects.error();
    request.suit = subjects->front().suit();
    auto data = evaluateTake(request, context.job());
    if (!data)
        return data.error();
    for (const std::string& warning : data->warnings)
        context.console.warn(warning);
    const ReportRun& shown = *data->shownRun();
    Outcome outcome{evaluationJson(*data, shown), evaluationText(*data, shown), std::nullopt};
    if (!understood.is_null())
        outcome.json["motion"] = std::move(understood);
    if (shown.comparison)
        outcome.json["joints_matched"] = matchedJson(*shown.comparison);
    std::vector<SubjectReport> reports;
    if (subjects->size() > 1) {
        if (Status added = addSubjects(context, request, *subjects, outcome, reports); !added)
            return added.error();
        if (Status added = addBetween(context, request, *subjects, outcome); !added)
            return added.error();
    } else if (!request.reference) {
        const auto in_room = addInRoom(context, request, subjects->front(), outcome.json);
        if (!in_room)
            return in_room.error();
        if (!in_room->empty())
            outcome.text += *in_room + "\n";
    }
    if (!report_path.empty()) {
        if (context.cancel.cancelled())
            return JobContext::cancelledError();
        context.console.progress(0.9, "Writing the report");
        if (subjects->size() > 1)
            data->take.performer = subjects->front().name;
        if (Status written = writeEvaluationPage(context, report_path, htmlReport(*data), outcome); !written)
            return written.error();
        if (Status written = writeOtherPages(context, report_path, reports, outcome); !written)
            return written.error();
    }
    if (!csv_path.empty()) {
        if (reports.empty())
            reports.push_back({subjects->front().name, std::move(*data)});
        if (Status written = writeFileAtomically(csv_path, jointsCsv(reports), overwrite); !written)
            return written.error();
        outcome.json["csv"] = csv_path;
        outcome.text += "joints as CSV         " + csv_path + "\n";
    }
    return outcome;
}

}  // namespace

Verb evaluateVerb() {
    Verb verb;
    verb.name = "evaluate";
    verb.summary = "compare a result with a reference and report how far it can be trusted";
    verb.operands = "T.noctule";
    verb.min_operands = verb.max_operands = 1;
    verb.example = "noctule --batch evaluate hops_001.noctule --report hops.html";
    verb.options = {text("run", "NAME", "the result to judge; the last one when not given"),
                    inputFile("reference", "M.bvh|M.fbx|M.glb",
                              "another system's motion, aligned in time; else the take's own"),
                    inputFiles("points", "P.csv",
                               "tables that process --estimator comocap --points wrote, instead of a result"),
                    text("report", "R.html", "write the whole report, with every result of the take"),
                    text("csv", "J.csv", "write the joints of every result as a table")};
    for (Option& option : motionOptions("reference"))
        verb.options.push_back(std::move(option));
    verb.remarks = {
        "Angles are geodesic, between local rotations, after the rest pose; \"mean\" is the mean over all "
        "joints with freedom, the root left out."};
    verb.run = runEvaluate;
    return verb;
}

}  // namespace noctule::batch
