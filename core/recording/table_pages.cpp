// SPDX-License-Identifier: Apache-2.0
#include "core/recording/table_pages.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <set>
#include <utility>

#include "core/recording/page_reader.h"

namespace noctule {
namespace {

constexpr int64_t kLowest = std::numeric_limits<int64_t>::min();
constexpr int64_t kHighest = std::numeric_limits<int64_t>::max();
constexpr int64_t kShortestRow_bytes = 6;  // with its entry in the page's list
constexpr double kMostRows = 1e12;         // of a table: a week of 10 MHz is as many

struct Child {
    int64_t page = 0, first = 0, last = 0;
};

class PageTree {
public:
    PageTree(std::istream& file, int64_t page_bytes) : page_(file, page_bytes), page_bytes_(page_bytes) {}

    /// `usual`: numbers of rows below a page beside this one.
    void visit(const Child& at, const std::optional<int64_t>& usual, int depth) {
        const bool is_read = depth < kMostLevels && visited_.insert(at.page).second && page_.read(at.page);
        const int kind = is_read ? page_.kind() : 0;
        const int64_t entries = is_read ? page_.entries() : 0;
        if (kind == kRowPage && entries <= page_bytes_ / kShortestRow_bytes) {
            const std::optional<int64_t> room = numbers(at);
            const int64_t rows = atMost(entries, room);
            pages_.push_back({at.first, at.last, rows, true, at.page});
            if (room) {
                rows_ += static_cast<double>(rows);
                numbers_ += static_cast<double>(*room);
            }
            return;
        }
        const std::vector<Child> below = kind == kInnerPage ? children(at) : std::vector<Child>();
        if (below.empty()) {
            const bool may_be_readable = kind == kInnerPage || kind == kRowPage;
            damaged_.push_back(pages_.size());
            pages_.push_back({at.first, at.last, estimate(at, usual), may_be_readable, at.page});
            return;
        }
        const std::optional<int64_t> usual_below = usualOf(below);
        for (const Child& child : below)
            visit(child, usual_below, depth + 1);
    }

    std::vector<RowPage> take() {
        for (const size_t page : damaged_) {
            std::optional<int64_t>& rows = pages_[page].rows;
            // Some programs number rows by their times: the other pages tell how densely.
            const double likely = rows && numbers_ > 0 ? static_cast<double>(*rows) * rows_ / numbers_ : -1;
            rows = likely >= 0 && likely < kMostRows ? std::optional(std::llround(likely)) : std::nullopt;
        }
        return std::move(pages_);
    }
    const std::set<int64_t>& visited() const { return visited_; }

private:
    /// Of the page that was read last; none when they contradict each other.
    std::vector<Child> children(const Child& at) const {
        constexpr int kList = 12;  // where the list of entries begins
        std::vector<Child> found;
        int64_t first = at.first;
        const int64_t start = page_.start(), entries = page_.entries();
        for (int64_t i = 0; i < entries; ++i) {
            const int64_t entry = page_.number(start + kList + 2 * i, 2);
            int64_t key = entry + 4;
            const int64_t last = page_.varint(key);
            if (last < first || last >= at.last)
                return {};
            found.push_back({page_.number(entry, 4), first, last});
            first = last + 1;
        }
        found.push_back({page_.number(start + 8, 4), first, at.last});
        return found;
    }

    /// How many row numbers it spans. Rows are numbered from 1 on; absent: it has no end.
    static std::optional<int64_t> numbers(const Child& of) {
        const int64_t first = of.first == kLowest && of.last > 0 ? 1 : of.first;
        if (of.last == kHighest || first == kLowest || (first < 0 && of.last >= kHighest + first))
            return std::nullopt;
        return of.last - first + 1;
    }
    static int64_t atMost(int64_t rows, const std::optional<int64_t>& most) {
        return most ? std::min(rows, *most) : rows;
    }

    /// Pages of one level hold alike many rows. Wider gaps in the numbers are rows that were removed.
    static std::optional<int64_t> usualOf(const std::vector<Child>& children) {
        std::vector<int64_t> all;
        for (const Child& child : children)
            if (const auto one = numbers(child))
                all.push_back(*one);
        if (all.empty())
            return std::nullopt;
        const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
        std::nth_element(all.begin(), middle, all.end());
        return *middle;
    }
    static std::optional<int64_t> estimate(const Child& of, const std::optional<int64_t>& usual) {
        const std::optional<int64_t> most = numbers(of);
        return usual && most ? std::min(*most, *usual > kHighest / 2 ? kHighest : 2 * *usual)
               : usual       ? usual
                             : most;
    }

    PageReader page_;
    const int64_t page_bytes_;
    std::set<int64_t> visited_;
    std::vector<RowPage> pages_;
    std::vector<size_t> damaged_;    ///< of them; numbers of rows instead of rows until the end
    double rows_ = 0, numbers_ = 0;  ///< of the sound ones
};

}  // namespace

std::vector<RowPage> rowPages(std::istream& file, int64_t page_bytes, int64_t root,
                              std::set<int64_t>* reached) {
    PageTree tree(file, page_bytes);
    tree.visit({root, kLowest, kHighest}, std::nullopt, 0);
    if (reached)
        reached->insert(tree.visited().begin(), tree.visited().end());
    return tree.take();
}

}  // namespace noctule
