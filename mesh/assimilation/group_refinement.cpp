#include "mesh/assimilation/group_refinement.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

using Leaves = std::vector<std::int32_t>;

/// The leaves fall into pieces that hang together; each ascending, by their first leaves.
std::vector<Leaves> pieces_of(const SubdomainGraph& graph, const Leaves& leaves) {
  std::set<std::int32_t> unseen(leaves.begin(), leaves.end());
  std::vector<Leaves> pieces;
  while (!unseen.empty()) {
    Leaves& piece = pieces.emplace_back(Leaves{*unseen.begin()});
    unseen.erase(unseen.begin());
    for (std::size_t i = 0; i < piece.size(); ++i) {
      for (const Neighbour& next : graph.neighbours[at(piece[i])]) {
        if (unseen.erase(next.leaf) > 0) piece.push_back(next.leaf);
      }
    }
    std::sort(piece.begin(), piece.end());
  }
  return pieces;
}

/// A leaf that goes from one group to another, and perhaps one that comes back for it.
struct Exchange {
  static constexpr std::int32_t none = -1;

  std::int32_t goes = none;
  std::int32_t comes = none;
  std::size_t from = 0;
  std::size_t to = 0;
  double gain = 0;
};

class Refinement {
 public:
  Refinement(const SubdomainGraph& graph, std::span<const std::int32_t> leaf2group)
      : graph_(graph), leaf2group_(leaf2group.size()) {
    TF_CHECK(!leaf2group.empty() && leaf2group.size() == graph.size());
    const std::int32_t last = *std::max_element(leaf2group.begin(), leaf2group.end());
    members_.resize(at(last) + 1);
    works_.resize(members_.size(), 0);
    for (std::size_t leaf = 0; leaf < leaf2group.size(); ++leaf) {
      enter(static_cast<std::int32_t>(leaf), at(leaf2group[leaf]));
    }
  }

  /// A piece that hangs on nothing of its group goes to the lightest group that it touches, or
  /// becomes a group where it touches none. Each step leaves fewer pieces in all.
  void connect() {
    for (std::size_t group = 0; group < members_.size(); ++group) {
      std::vector<Leaves> pieces = pieces_of(graph_, members_[group]);
      if (pieces.size() < 2) continue;
      const auto heaviest = std::max_element(
          pieces.begin(), pieces.end(),
          [this](const Leaves& a, const Leaves& b) { return work_of(a) < work_of(b); });
      pieces.erase(heaviest);
      for (const Leaves& piece : pieces) move_piece(piece, group);
    }
  }

  /// A group that got no leaf takes one from the heaviest that can spare one.
  void fill_empty_groups() {
    for (std::size_t group = 0; group < members_.size(); ++group) {
      if (members_[group].empty()) fill(group);
    }
  }

  void balance(double balanced) {
    const double total = std::accumulate(graph_.work.begin(), graph_.work.end(), 0.0);
    const double mean = total / static_cast<double>(members_.size());
    const std::size_t most_exchanges = 20 * graph_.size();
    for (std::size_t i = 0; i < most_exchanges; ++i) {
      if (*std::max_element(works_.begin(), works_.end()) <= balanced * mean) return;
      if (!exchange_for_the_worst(mean)) return;
    }
  }

  /// Numbered by their first leaves; empty groups are gone.
  std::vector<std::int32_t> result() const {
    std::vector<std::int32_t> group2number(members_.size(), -1);
    std::vector<std::int32_t> numbers;
    std::int32_t next = 0;
    for (const std::size_t group : leaf2group_) {
      if (group2number[group] < 0) group2number[group] = next++;
      numbers.push_back(group2number[group]);
    }
    return numbers;
  }

 private:
  double work_of(const Leaves& leaves) const {
    double work = 0;
    for (const std::int32_t leaf : leaves) work += graph_.work[at(leaf)];
    return work;
  }

  void enter(std::int32_t leaf, std::size_t group) {
    leaf2group_[at(leaf)] = group;
    Leaves& members = members_[group];
    members.insert(std::lower_bound(members.begin(), members.end(), leaf), leaf);
    works_[group] = work_of(members);
  }

  void leave(std::int32_t leaf) {
    const std::size_t group = leaf2group_[at(leaf)];
    std::erase(members_[group], leaf);
    works_[group] = work_of(members_[group]);
  }

  void move(std::int32_t leaf, std::size_t group) {
    TF_CHECK(leaf2group_[at(leaf)] != group);
    leave(leaf);
    enter(leaf, group);
  }

  void move_piece(const Leaves& piece, std::size_t from) {
    std::size_t to = members_.size();
    for (const std::int32_t leaf : piece) {
      for (const Neighbour& next : graph_.neighbours[at(leaf)]) {
        const std::size_t group = leaf2group_[at(next.leaf)];
        if (group == from) continue;
        const bool is_lighter = to == members_.size() || works_[group] < works_[to] ||
                                (works_[group] == works_[to] && group < to);
        if (is_lighter) to = group;
      }
    }
    if (to == members_.size()) {
      members_.emplace_back();
      works_.push_back(0);
    }
    for (const std::int32_t leaf : piece) move(leaf, to);
  }

  bool is_connected(const Leaves& leaves) const { return pieces_of(graph_, leaves).size() == 1; }

  Leaves changed(std::size_t group, std::int32_t without, std::int32_t with) const {
    Leaves leaves = members_[group];
    std::erase(leaves, without);
    if (with != Exchange::none) leaves.push_back(with);
    return leaves;
  }

  void fill(std::size_t empty) {
    std::vector<std::size_t> heaviest(members_.size());
    std::iota(heaviest.begin(), heaviest.end(), std::size_t{0});
    std::stable_sort(heaviest.begin(), heaviest.end(),
                     [this](std::size_t a, std::size_t b) { return works_[a] > works_[b]; });
    for (const std::size_t group : heaviest) {
      if (members_[group].size() < 2) continue;
      for (const std::int32_t leaf : members_[group]) {
        if (!is_connected(changed(group, leaf, Exchange::none))) continue;
        move(leaf, empty);
        return;
      }
    }
  }

  /// The best exchange of the group that is farthest from the mean and has one.
  bool exchange_for_the_worst(double mean) {
    std::vector<std::size_t> worst(members_.size());
    std::iota(worst.begin(), worst.end(), std::size_t{0});
    std::stable_sort(worst.begin(), worst.end(), [&](std::size_t a, std::size_t b) {
      return std::fabs(works_[a] - mean) > std::fabs(works_[b] - mean);
    });
    for (const std::size_t group : worst) {
      std::vector<Exchange> exchanges = exchanges_of(group, mean);
      std::stable_sort(exchanges.begin(), exchanges.end(),
                       [](const Exchange& a, const Exchange& b) { return a.gain > b.gain; });
      for (const Exchange& exchange : exchanges) {
        if (try_exchange(exchange)) return true;
      }
    }
    return false;
  }

  bool try_exchange(const Exchange& e) {
    const bool fits = is_connected(changed(e.from, e.goes, e.comes)) &&
                      is_connected(changed(e.to, e.comes, e.goes));
    if (!fits) return false;
    move(e.goes, e.to);
    if (e.comes != Exchange::none) move(e.comes, e.from);
    return true;
  }

  /// Those between this group and its neighbours that even out the work, in a fixed order.
  std::vector<Exchange> exchanges_of(std::size_t group, double mean) const {
    std::vector<Exchange> exchanges;
    for (const auto& [other, here, there] : borders_of(group)) {
      for (const std::int32_t a : here) {
        consider({a, Exchange::none, group, other, 0}, mean, exchanges);
        for (const std::int32_t b : there) consider({a, b, group, other, 0}, mean, exchanges);
      }
      for (const std::int32_t b : there) {
        consider({b, Exchange::none, other, group, 0}, mean, exchanges);
      }
    }
    return exchanges;
  }

  /// Two groups that touch, and the leaves of each that touch the other.
  struct Border {
    std::size_t other = 0;
    std::set<std::int32_t> here;
    std::set<std::int32_t> there;
  };

  std::vector<Border> borders_of(std::size_t group) const {
    std::vector<Border> borders;
    for (const std::int32_t leaf : members_[group]) {
      for (const Neighbour& next : graph_.neighbours[at(leaf)]) {
        const std::size_t other = leaf2group_[at(next.leaf)];
        if (other == group) continue;
        auto border = std::find_if(borders.begin(), borders.end(),
                                   [other](const Border& b) { return b.other == other; });
        if (border == borders.end()) border = borders.insert(border, Border{other, {}, {}});
        border->here.insert(leaf);
        border->there.insert(next.leaf);
      }
    }
    std::sort(borders.begin(), borders.end(),
              [](const Border& a, const Border& b) { return a.other < b.other; });
    return borders;
  }

  /// The gain is what the squares of the distances to the mean become smaller by.
  void consider(Exchange exchange, double mean, std::vector<Exchange>& exchanges) const {
    constexpr double least = 1e-9;
    const double back = exchange.comes == Exchange::none ? 0 : graph_.work[at(exchange.comes)];
    const double moved = graph_.work[at(exchange.goes)] - back;
    const double from = works_[exchange.from] - mean;
    const double to = works_[exchange.to] - mean;
    exchange.gain =
        from * from + to * to - (from - moved) * (from - moved) - (to + moved) * (to + moved);
    if (exchange.gain > least * mean * mean) exchanges.push_back(exchange);
  }

  const SubdomainGraph& graph_;
  std::vector<std::size_t> leaf2group_;
  std::vector<Leaves> members_;
  std::vector<double> works_;
};

}  // namespace

std::vector<std::int32_t> refine_groups(const SubdomainGraph& graph,
                                        std::span<const std::int32_t> leaf2group,
                                        const RefinementOptions& options) {
  Refinement refinement(graph, leaf2group);
  refinement.connect();
  refinement.fill_empty_groups();
  refinement.balance(options.balanced);
  return refinement.result();
}

std::vector<std::vector<std::int32_t>> connected_pieces(const SubdomainGraph& graph) {
  Leaves all(graph.size());
  std::iota(all.begin(), all.end(), 0);
  return pieces_of(graph, all);
}

bool groups_are_connected(const SubdomainGraph& graph, std::span<const std::int32_t> leaf2group) {
  std::map<std::int32_t, Leaves> groups;
  for (std::size_t leaf = 0; leaf < leaf2group.size(); ++leaf) {
    groups[leaf2group[leaf]].push_back(static_cast<std::int32_t>(leaf));
  }
  return std::all_of(groups.begin(), groups.end(),
                     [&](const auto& group) { return pieces_of(graph, group.second).size() == 1; });
}

}  // namespace tetfarm
