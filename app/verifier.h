#pragma once
/// Checks a replay against its recording, step by step, and names the first difference.
#include <cstdint>
#include <string>

#include "app/lockstep.h"

namespace halsted::app {

class Verifier {
 public:
  /// After a step. False once nothing more can be learned: a hash differed and, where a later whole state was stored, its first
  /// differing field has been found.
  bool check(const Lockstep&);
  bool failed() const { return failed_; }
  std::uint64_t stepsChecked() const { return checked_; }
  /// One line; empty while everything is equal.
  std::string message() const;

 private:
  bool failed_ = false;
  std::uint64_t checked_ = 0, firstStep_ = 0, fieldStep_ = 0;
  std::uint64_t recorded_ = 0, found_ = 0;
  std::string field_;
};

}  // namespace halsted::app
