// The processes that share one work: the ranks that mpirun started, or this process alone.
//
// Every rank runs the same program on the same input. Pieces of work have owners; what an owner
// computed is exchanged, and every rank adds it up in the same order, so that all of them come to
// the bits that one rank alone comes to. The root writes files and prints; the others do not.
//
// With WARPLUT_RANK_TIMES in the environment each rank of a build with MPI tells at its end, on
// standard error, its processor time and its exchanges.
//
// All calls are for the main thread. Collective calls wait for the other ranks: each rank makes
// them in the same order.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace warplut {

class Ranks {
 public:
  // Starts MPI at the first call if mpirun started this process and the build has MPI. Error: it
  // did, and the build has none.
  static Ranks& World();
  // The same if World was called before and succeeded; else null.
  static const Ranks* Started();

  int rank() const { return rank_; }    // in [0, count())
  int count() const { return count_; }  // at least 1
  bool IsRoot() const { return rank_ == 0; }

  // Collective: waits until every rank is here.
  void Meet();

  // Collective: waits until the root is here, without work for the processor, so that what the root
  // measures meanwhile is not disturbed.
  void WaitForRoot();

  // Collective: whether any rank says so.
  bool Any(bool here);

  // Collective: the root's value.
  double OfRoot(double value);

  // Collective: items[i] of rank owners[i], whatever its length, becomes items[i] of every rank.
  // Owners are in [0, count()).
  void Exchange(std::span<const int> owners, std::vector<std::vector<double>>& items);

  // Collective: an Error on every rank if a rank has another text than the root; `subject` names
  // what differs, as "the options".
  void RequireSame(const std::string& subject, const std::string& text);

  // Ends all ranks with this exit code; returns on a single rank alone.
  void Abort(int code) const;

  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

 private:
  friend class AloneOnRank;
  Ranks();
  ~Ranks();

  int rank_ = 0;
  int count_ = 1;
};

// While it lives, World() is this rank alone, its root: no call waits, and nothing is exchanged.
// For a piece of work that one rank does and that would be shared otherwise. Made on the main
// thread.
class AloneOnRank {
 public:
  AloneOnRank();
  ~AloneOnRank();
  AloneOnRank(const AloneOnRank&) = delete;
  AloneOnRank& operator=(const AloneOnRank&) = delete;

 private:
  int rank_, count_;  // as they were
};

// Owners of pieces of work, work[i] >= 0 each: the largest first, each to the rank that has least.
// The same on every rank.
std::vector<int> BalancedOwners(std::span<const double> work, int ranks);

// Owners of pieces that lie in an order, work[i] > 0 each: neighbours have one owner as far as
// shares of the work allow, so that what neighbours have in common is loaded by few. A piece goes
// to the rank in whose share of the whole its middle lies: no share is larger than the mean by
// more than one piece. The same on every rank.
std::vector<int> ContiguousOwners(std::span<const double> work, int ranks);

}  // namespace warplut
