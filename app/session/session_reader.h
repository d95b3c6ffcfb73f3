#pragma once
/// Reads and checks a session file. Throws scenes::InputError, one line that names the file, for anything that is not a whole
/// session of this or an earlier format. One thread at a time.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/database.h"
#include "app/session/session_format.h"

namespace halsted::app {

class SessionReader {
 public:
  explicit SessionReader(const std::string& path);

  const SessionHeader& header() const { return header_; }
  std::uint64_t steps() const { return steps_; }
  bool closedProperly() const { return closed_; }              // false: the program was killed, or steps are gone from the end; what is there is valid
  const std::string& path() const { return path_; }

  /// Consumed input of the next step and the hash of the state after it; false at the end.
  bool next(StepInput&, std::uint64_t& stateHash);
  /// The whole state stored after exactly this many steps, if there is one.
  std::optional<std::vector<std::uint8_t>> stateAfter(std::uint64_t step);
  /// The last step, no later than this one, after which a whole state was stored.
  std::optional<std::uint64_t> storedBefore(std::uint64_t step);
  /// `next` goes on with the input of the step after this many.
  void seek(std::uint64_t step);

 private:
  void open();
  void readHeader();
  void readAnatomy();
  void readStart();
  void countSteps();
  void checkEnd();
  void loadChunk();
  [[noreturn]] void reject(const std::string& why) const;
  template <typename Action> void guarded(Action action);      // DatabaseError -> InputError

  std::string path_;
  std::unique_ptr<Database> database_;
  SessionHeader header_;
  std::uint64_t steps_ = 0, nextStep_ = 0, chunkStart_ = 0;
  Blob inputs_, hashes_;
  std::string endHash_;                        // of the last state, as the file says
  bool closed_ = false;
};

}  // namespace halsted::app
