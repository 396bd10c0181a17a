// SPDX-License-Identifier: Apache-2.0
// The take that is open for review, with the parts that have been loaded so far. Loading runs as jobs;
// signals tell when a part has come. Parts are shared and never change once loaded: views may keep them. The
// document keeps the parts of the runs that are shown and compared only, so that memory stays flat.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <map>
#include <memory>
#include <optional>

#include "core/motion/foot_contacts.h"
#include "core/processing/evaluate_between.h"
#include "core/report/take_verdict.h"
#include "core/review/between_curve.h"
#include "core/review/joint_curves.h"
#include "core/review/plot_series.h"
#include "core/review/take_review.h"
#include "ui/jobs/jobs.h"
#include "ui/models/time_cursor.h"

namespace noctule::ui {

class TakeDocument : public QObject {
    Q_OBJECT
public:
    TakeDocument(Jobs& jobs, TimeCursor& time, QObject* parent = nullptr);
    ~TakeDocument() override;

    bool isOpen() const { return overview_ != nullptr; }
    QString path() const { return path_; }
    /// Null until opened().
    std::shared_ptr<const TakeOverview> overview() const { return overview_; }

    /// The people of the take, and which of them the shown parts are of; 0 when it is one or none.
    const std::vector<TakeSubject>& subjects() const;
    int subject() const;
    /// All parts are read anew; opened() tells.
    void setSubject(int index);
    /// The take as that one's suit sees it.
    TakeView view() const;
    bool isOfSeveral() const { return subjects().size() > 1; }
    /// Whether somebody wears sources, or the room has them: else there are no pairs. True while no take is
    /// open.
    bool hasSources() const;
    /// Whose sources the pairs are of, an index into overview()->parties; at first the shown person's own.
    int sourcesOf() const { return sources_of_; }
    void setSourcesOf(int party);
    bool showsOwnPairs() const { return sources_of_ == subject(); }
    /// The sources and boards of the pairs; not null while a take is open.
    std::shared_ptr<const Suit> pairSuit() const { return pair_suit_; }

    /// The result that is shown and the one that it is compared with (-1: none; kReference: the take's own).
    static constexpr int kReference = -2;
    int shownRun() const { return shown_; }  ///< index into overview()->runs, -1: none
    int comparedRun() const { return compared_; }
    /// "2": results are numbered in the order they were made and keep their number for good, also when an
    /// earlier one is deleted. Empty: there is none.
    QString numberOf(int index) const;
    void setShownRun(int index);
    void setComparedRun(int index);

    // Null until loaded; asking starts loading. The signal comes too when loading failed; the part stays
    // null and problem() says why.
    std::shared_ptr<const TimedMotion> shownMotion();
    std::shared_ptr<const TimedMotion> comparedMotion();
    std::shared_ptr<const TimedMotion> reference();
    std::shared_ptr<const std::vector<FootContacts>> contacts();  ///< of the shown motion
    std::shared_ptr<const RangeTable> ranges();                   ///< those that the shown run used
    std::shared_ptr<const PairSummaries> pairSummaries();         ///< of ranges()
    std::shared_ptr<const ReadingTable> readings();
    std::shared_ptr<const TimedMotion> motionOf(int subject);  ///< of the shown run
    std::shared_ptr<const ReportData> report();  ///< of the shown run; read after all of the above
    /// Where the people of the shown run are to each other, against their references; read like report().
    std::shared_ptr<const std::vector<BetweenEvaluation>> between();
    std::shared_ptr<const TakeVerdict> verdict();  ///< of report()

    // One curve each, ready to draw at any zoom; of the shown run unless said otherwise. Null until loaded;
    // asking starts loading, curvesChanged() tells.
    enum class Whose { kShown, kCompared, kReference };
    std::shared_ptr<const SeriesPyramid> rangeCurve(int source, int board, RangeQuantity quantity);
    std::shared_ptr<const SeriesPyramid> readingCurve(int board, int axis);
    std::shared_ptr<const MotionCurve> motionCurve(const CurveChoice& choice, Whose whose = Whose::kShown);
    /// How far two subjects are from each other, the earlier one first.
    std::shared_ptr<const std::vector<BetweenTrack>> betweenTracks(int subject, int other,
                                                                   Whose whose = Whose::kShown);

    /// What went wrong with the part that failed last, and what to do; empty when none did since the take was
    /// opened or reloaded.
    const QString& problem() const { return problem_; }
    /// Whether something of the file could not be read since its database is torn.
    bool isDamaged() const { return damaged_; }
    /// Work on the take at `path`, which need not be this one, found its database torn; torn() tells.
    void noteDamage(const QString& path, const Error& error);
    /// Whether anything is being read.
    bool isLoading() const;
    /// The job that makes a result of the take at `path`; views of that take tell of it.
    void followProcessing(const QString& path, Job* job);
    /// Of this take, while it runs; else null.
    Job* processing() const;

public slots:
    /// `result`: name of the one that is shown first; empty, or none is called so: the newest.
    void open(const QString& path, const std::string& result = {});
    void close();
    /// The file has another name now.
    void followMove(const QString& path);
    /// Reads the overview again (after processing, attaching) and keeps the choice of runs where it can; the
    /// newest run is shown when `show_newest`.
    void reload(bool show_newest);

signals:
    void processingChanged();
    void opened();  ///< overview is there, or the document was closed
    void failed(const QString& message);
    /// The file is torn, part of it may be readable. Instead of failed(), or once a part could not be read.
    void torn(const QString& path, const QString& why);
    void runsChanged();    ///< list or choice
    void motionChanged();  ///< a motion or the contacts have been loaded
    void rangesChanged();
    void readingsChanged();
    void reportChanged();
    void curvesChanged();

private:
    /// One thing that is loaded on demand. A result whose ticket is not the part's own is an earlier one's.
    template <class T>
    struct Part {
        std::shared_ptr<const T> value;
        bool ended = false;  ///< well or not
        uint64_t ticket = 0;
        uint64_t asked = 0;  ///< when last asked for: the oldest curves go first
        QPointer<Job> job;
    };
    template <class Key, class T>
    using Parts = std::map<Key, Part<T>>;
    using Changed = void (TakeDocument::*)();
    template <class T>
    using Work = std::function<Result<T>(const JobContext&)>;

    struct Judged {
        ReportData report;
        TakeVerdict verdict;
        std::vector<BetweenEvaluation> between;
    };
    struct Ranges {
        RangeTable table;
        PairSummaries summaries;
    };
    struct RangeCurveKey {
        int64_t run;
        int source, board;
        RangeQuantity quantity;
        auto operator<=>(const RangeCurveKey&) const = default;
    };
    struct ReadingCurveKey {
        int64_t run;
        int board, axis;
        auto operator<=>(const ReadingCurveKey&) const = default;
    };
    struct MotionCurveKey {
        int64_t run;
        CurveChoice choice;
        auto operator<=>(const MotionCurveKey&) const = default;
    };

    struct BetweenKey {
        int64_t run;
        int suit, other_suit;
        auto operator<=>(const BetweenKey&) const = default;
    };

    /// The part; starts loading when it is asked for the first time.
    template <class Key, class T>
    std::shared_ptr<const T> ask(Parts<Key, T>& parts, const Key& key, const QString& title, Changed changed,
                                 Work<T> work);
    template <class Key, class T>
    void accept(Parts<Key, T>& parts, const Key& key, uint64_t ticket, Result<T> result, Changed changed);
    /// Drops the parts for which it holds and cancels their loading.
    template <class Key, class T, class Unwanted>
    static void drop(Parts<Key, T>& parts, Unwanted unwanted);
    template <class Key, class T>
    static void keepNewest(Parts<Key, T>& parts);
    template <class Visit>
    void forEachKind(Visit visit);

    void loadOverview(const TakeView& view, bool show_newest);
    void accept(TakeOverview overview, bool show_newest);
    void refuse(const Error& error);
    void motionLoaded();
    void rangesLoaded();
    void readingsLoaded();
    void listenTo(int party);
    void composePairSuit();
    void forget();
    void forgetUnshown();
    /// Parts of runs that the take no longer holds as they were, and what failed to load.
    void forgetOutdated(const TakeOverview& earlier);
    void showFrames();

    /// Number of a run of the take, kReference for the reference, absent for none.
    std::optional<int64_t> runNumber(int index) const;
    const ReviewRun* shown() const;
    std::optional<int64_t> runOf(Whose whose) const;
    /// False: the box was lost in the rest pose, no run has a motion of it, and nothing is to be loaded.
    bool hasMotion(int suit) const;
    std::shared_ptr<const TimedMotion> motion(std::optional<int64_t> run);
    std::shared_ptr<const Ranges> rangesWithSummaries();
    std::shared_ptr<const Judged> judged();
    bool readsForViews() const;
    void judgeWhenAwaited();

    Jobs& jobs_;
    TimeCursor& time_;
    QString path_, problem_;
    std::string first_shown_;                      ///< as open() was asked
    std::map<QString, QPointer<Job>> processing_;  ///< by path
    uint64_t ticket_ = 0, overview_ticket_ = 0;
    QPointer<Job> overview_job_;
    std::shared_ptr<const TakeOverview> overview_;
    std::shared_ptr<const Suit> pair_suit_;
    int sources_of_ = 0;
    int shown_ = -1, compared_ = -1;
    bool damaged_ = false;
    bool report_awaited_ = false;  ///< asked for while what moves and is plotted was still being read

    // By number of the run; kReference: the reference.
    Parts<int64_t, TimedMotion> motions_;
    Parts<std::pair<int64_t, int>, TimedMotion> others_;  ///< of the other subjects: run, suit
    Parts<BetweenKey, std::vector<BetweenTrack>> between_;
    Parts<int64_t, std::vector<FootContacts>> contacts_;
    Parts<int64_t, Ranges> ranges_;
    Parts<int64_t, ReadingTable> readings_;
    Parts<int64_t, Judged> reports_;
    Parts<RangeCurveKey, SeriesPyramid> range_curves_;
    Parts<ReadingCurveKey, SeriesPyramid> reading_curves_;
    Parts<MotionCurveKey, MotionCurve> motion_curves_;
};

}  // namespace noctule::ui
