#include "engine/app/budget/search.hpp"
#include <algorithm>

namespace afterglow
{
namespace
{
constexpr int kSizes = 6;     // of the plain frame that are tried
constexpr double kUsed = 0.8; // of the time: a frame that takes less is not the largest that fits, for one before it was seen too slow
constexpr int kProposals = 5; // of all effects together

struct Search {
    const Curves& curves;
    const double most; // ms
    const Trials& trials;
    std::vector<Tried> tried = {};
    double off = 1.0; // ms seen over predicted, of the last

    std::ptrdiff_t looks(const Choice& choice) const
    {
        return std::count_if(tried.begin(), tried.end(), [&](const Tried& t) { return t.choice == choice; });
    }
    bool known(const Choice& choice) const { return looks(choice) > 0; }

    Tried look(const Choice& choice)
    {
        const Price seen{trials.ms(choice), trials.error(choice)};
        off = seen.ms / predicted(curves, choice).ms;
        return tried.emplace_back(Tried{choice, seen, seen.ms <= most});
    }

    // The default frame at the largest size that fits, or at the smallest.
    Tried plain()
    {
        std::optional<Tried> best;
        for (int i = 0; i < kSizes; ++i) {
            const bool wasteful = best && best->fits && best->seen.ms < kUsed * most;
            if (wasteful) off = best->seen.ms / predicted(curves, best->choice).ms;
            const Choice choice = stretched(curves, plainChoice(curves), most / off);
            if (looks(choice) > (wasteful ? 1 : 0) || (best && choice == best->choice)) break;
            const Tried now = look(choice);
            const bool better =
                !best || (now.fits && !best->fits) ||
                (now.fits == best->fits && (now.fits ? now.choice.scale > best->choice.scale : now.seen.ms < best->seen.ms));
            if (better) best = now;
        }
        return *best;
    }

    bool beats(const Tried& a, const Tried& b) const { return a.fits && (!b.fits || a.seen.error < b.seen.error); }

    // What the prices say of all effects together.
    void together(Tried& best)
    {
        for (int i = 0; i < kProposals; ++i) {
            const Choice choice = propose(curves, most / off);
            if (known(choice)) break;
            if (const Tried now = look(choice); beats(now, best)) best = now;
        }
    }

    // Where their sum told wrong: one effect's at a time, the most promising first, kept if it is seen to be better.
    void oneByOne(Tried& best, const Choice& proposed)
    {
        std::vector<std::size_t> changed;
        for (std::size_t g = 0; g < proposed.options.size(); ++g)
            if (proposed.options[g] != best.choice.options[g]) changed.push_back(g);
        const auto with = [&](std::size_t g) {
            Choice choice = best.choice;
            choice.options[g] = proposed.options[g];
            return stretched(curves, choice, most / off);
        };
        std::map<std::size_t, double> promise;
        for (const std::size_t g : changed) promise[g] = predicted(curves, with(g)).error;
        std::sort(changed.begin(), changed.end(), [&](std::size_t a, std::size_t b) { return promise[a] < promise[b]; });
        for (const std::size_t g : changed) {
            if (tried.size() >= std::size_t(kMostTrials)) break;
            const Choice choice = with(g);
            if (known(choice)) continue;
            if (const Tried now = look(choice); beats(now, best)) best = now;
        }
    }

    // Where nothing fits: a frame that nobody can use is no saving. Of what is no slower than the plain frame and not much worse, the least
    // error that keeps the budget without its margin; where none does, the least error of those that are not much slower than the fastest.
    Tried leastHarm(const Tried& plain) const
    {
        std::vector<Tried> usable;
        for (const Tried& t : tried)
            if (t.seen.ms <= plain.seen.ms && t.seen.error <= kMuch * kMuch * plain.seen.error) usable.push_back(t);
        const auto least = [&](double Price::*what) {
            return *std::min_element(usable.begin(), usable.end(), [&](auto& a, auto& b) { return a.seen.*what < b.seen.*what; });
        };
        const double fastest = least(&Price::ms).seen.ms, budget = most / (1.0 - kMargin);
        std::erase_if(usable, [&](const Tried& t) { return t.seen.ms > (fastest <= budget ? budget : kMuch * fastest); });
        return least(&Price::error);
    }

    // The smaller frame, or the whole one where that takes hardly longer and is off by less: a fast device's frame does not go by its
    // pixels.
    Tried worthIt(const Tried& smaller)
    {
        const Choice all = plainChoice(curves);
        const auto found = std::find_if(tried.begin(), tried.end(), [&](const Tried& t) { return t.choice == all; });
        const Tried whole = found != tried.end() ? *found : look(all);
        return whole.seen.ms <= kMuch * kMuch * smaller.seen.ms && whole.seen.error < smaller.seen.error ? whole : smaller;
    }
};
}

Found search(const Curves& curves, double ms, const Trials& trials)
{
    Search search{curves, ms, trials};
    const Tried plain = search.plain();
    Tried best = plain;
    search.together(best);
    if (best.choice == plain.choice) search.oneByOne(best, propose(curves, ms / search.off));
    return {best.fits ? best : search.worthIt(search.leastHarm(plain)), plain};
}
}
