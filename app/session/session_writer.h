#pragma once
/// Writes a session file. Used by one thread (the recorder, or the only one in lockstep).
/// Records are gathered and committed four times a second: a killed program loses less than a second, and the file stays valid.
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "app/session/database.h"
#include "app/session/session_format.h"

namespace halsted::app {

class SessionWriter {
 public:
  /// Replaces an earlier session of that name; throws scenes::InputError when the file is something else, SystemFault when it
  /// cannot be written.
  SessionWriter(const std::string& path, const SessionHeader&);
  ~SessionWriter();                            // commits what is left, and says nothing if that fails
  SessionWriter(const SessionWriter&) = delete;
  SessionWriter& operator=(const SessionWriter&) = delete;

  void addStep(const StepInput&, std::uint64_t stateHash);
  void addEvent(const Event&);
  void addState(std::uint64_t step, const std::vector<std::uint8_t>& saved);
  void addHaptic(const HapticRecord&);
  void note(const std::string& key, const std::string& value);
  void commitWhenDue();                        // at most every 250 ms; later where somebody holds the file
  void close();                                // commits and marks the session as ended properly, with the last recorded state

  std::uint64_t steps() const { return firstStep_ + hashes_.size() / 8; }
  const std::string& path() const { return path_; }

 private:
  void createTables();
  void writeHeader(const SessionHeader&);
  void insertGathered();
  bool commit();                               // false: somebody reads the file, the transaction stays open
  template <typename Action> void guarded(Action action);        // DatabaseError -> SystemFault naming the file

  std::string path_;
  std::unique_ptr<Database> database_;
  std::uint64_t firstStep_ = 0;                // of the chunk being gathered
  Blob inputs_, hashes_;
  std::vector<HapticRecord> haptic_;
  std::uint64_t lastHash_ = 0;                 // of the state after the last step
  bool closed_ = false;
  std::chrono::steady_clock::time_point lastCommit_;
};

}  // namespace halsted::app
