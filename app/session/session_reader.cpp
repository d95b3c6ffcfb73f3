#include "app/session/session_reader.h"

#include <sqlite3.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "app/hexadecimal.h"
#include "app/session/mesh_codec.h"
#include "app/session/step_codec.h"
#include "scenes/input_text.h"

namespace halsted::app {
namespace {

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) found.push_back(line);
  return found;
}

}  // namespace

void SessionReader::reject(const std::string& why) const { throw scenes::InputError(path_ + ": " + why); }

template <typename Action>
void SessionReader::guarded(Action action) {
  try {
    action();
  } catch (const DatabaseError& error) {
    if (error.code == SQLITE_NOTADB) reject("not a Halsted session");
    if (error.code == SQLITE_CORRUPT) reject("damaged or cut short: " + error.what);
    reject("cannot read the session: " + error.what);
  }
}

SessionReader::SessionReader(const std::string& path) : path_(path) {
  guarded([&] { open(); });
  guarded([&] { readHeader(); });
  guarded([&] { readAnatomy(); });
  guarded([&] { readStart(); });
  guarded([&] { countSteps(); });
  guarded([&] { checkEnd(); });
}

void SessionReader::open() {
  std::error_code ignored;
  if (!std::filesystem::exists(path_, ignored)) reject("no such file");
  if (!std::filesystem::is_regular_file(path_, ignored)) reject("not a file");
  database_ = std::make_unique<Database>(path_, Database::Mode::kRead);
  const std::int64_t magic = database_->pragma("application_id"), format = database_->pragma("user_version");
  if (magic != kSessionMagic) reject("not a Halsted session");
  if (format > kSessionFormat)
    reject("written by a newer Halsted (format " + std::to_string(format) + "; this one reads up to " + std::to_string(kSessionFormat) + ")");
  if (format < 1) reject("unknown format " + std::to_string(format));
  Statement foreign = database_->prepare("SELECT name FROM sqlite_master WHERE type NOT IN ('table','index') OR sql LIKE 'CREATE VIRTUAL%' LIMIT 1");
  if (foreign.step()) reject("not a Halsted session: it holds more than tables: " + scenes::quoted(foreign.text(0)));
  Statement check = database_->prepare("PRAGMA quick_check(1)");
  if (!check.step() || check.text(0) != "ok") reject("damaged or cut short: " + check.text(0));
}

void SessionReader::readHeader() {
  std::map<std::string, std::string> meta;
  Statement rows = database_->prepare("SELECT key, value FROM meta");
  while (rows.step()) meta[rows.text(0)] = rows.text(1);
  for (const char* key : {"scene", "scene_text", "expert_text", "overrides", "dt_s", "seed", "closed"})
    if (!meta.count(key)) reject(std::string("meta.") + key + ": missing");
  header_.scene = meta["scene"];
  header_.sceneText = meta["scene_text"];
  header_.expertText = meta["expert_text"];
  header_.overrides = lines(meta["overrides"]);
  header_.program = meta["program"];
  header_.created = meta["created"];
  header_.trainee = meta["trainee"];
  header_.devices = {meta["left_device"], meta["right_device"]};
  std::istringstream dt(meta["dt_s"]), seed(meta["seed"]);
  dt.imbue(std::locale::classic());
  if (!(dt >> header_.dt) || !(header_.dt > 0.0 && header_.dt <= 0.1)) reject("meta.dt_s: not a time step: " + meta["dt_s"]);
  if (!(seed >> header_.seed)) reject("meta.seed: not a number: " + meta["seed"]);
  closed_ = meta["closed"] == "yes";
  endHash_ = meta["state_hash"];
  Statement parameters = database_->prepare("SELECT key, value FROM parameter ORDER BY key");
  while (parameters.step()) header_.parameters.push_back(parameters.text(0) + "=" + parameters.text(1));
}

void SessionReader::readAnatomy() {
  Statement row = database_->prepare("SELECT content, hash FROM anatomy");
  if (!row.step()) reject("anatomy: missing");
  const Blob content = row.blob(0);
  if (static_cast<std::int64_t>(contentHash(content)) != row.integer(1)) reject("anatomy: damaged (its checksum differs)");
  std::string error;
  if (!decodeAnatomy(content, header_.anatomy, error)) reject("anatomy: " + error);
}

void SessionReader::readStart() {
  Statement rows = database_->prepare("SELECT hand, pose FROM start ORDER BY hand");
  for (int hand = 0; hand < kHands; ++hand) {
    if (!rows.step() || rows.integer(0) != hand) reject("start: a hand is missing");
    const Blob pose = rows.blob(1);
    if (pose.size() != kPoseBytes) reject("start: a pose of the wrong size");
    header_.start[hand] = decodePose(pose);
    const std::string wrong = flaw(header_.start[hand]);
    if (!wrong.empty()) reject("start: " + wrong);
  }
}

/// Chunks must follow each other without a gap.
void SessionReader::countSteps() {
  Statement rows = database_->prepare("SELECT first_step, count, length(inputs), length(hashes) FROM chunk ORDER BY first_step");
  while (rows.step()) {
    const std::int64_t first = rows.integer(0), count = rows.integer(1);
    const std::string where = "chunk at step " + std::to_string(first) + ": ";
    if (first != static_cast<std::int64_t>(steps_)) reject(where + "expected step " + std::to_string(steps_));
    if (count <= 0 || count > 1'000'000) reject(where + "impossible length " + std::to_string(count));
    if (rows.integer(2) != count * static_cast<std::int64_t>(kStepInputBytes) || rows.integer(3) != count * 8)
      reject(where + "its data has the wrong size");
    steps_ += static_cast<std::uint64_t>(count);
  }
}

/// A session that ended properly ends with the state that it names: the last steps may have been taken out since.
void SessionReader::checkEnd() {
  std::string recorded;
  Statement row = database_->prepare("SELECT hashes FROM chunk ORDER BY first_step DESC LIMIT 1");
  if (row.step()) {
    const Blob hashes = row.blob(0);
    recorded = hexadecimal(decodeWord(std::span(hashes).last(8)));
  }
  closed_ = closed_ && recorded == endHash_;
}

void SessionReader::loadChunk() {
  Statement row = database_->prepare("SELECT inputs, hashes, first_step FROM chunk WHERE first_step<=? ORDER BY first_step DESC LIMIT 1");
  row.bind(1, static_cast<std::int64_t>(nextStep_));
  if (!row.step()) reject("chunk at step " + std::to_string(nextStep_) + ": missing");
  inputs_ = row.blob(0);
  hashes_ = row.blob(1);
  chunkStart_ = static_cast<std::uint64_t>(row.integer(2));
  if (inputs_.empty() || hashes_.empty() || inputs_.size() / kStepInputBytes != hashes_.size() / 8)
    reject("chunk at step " + std::to_string(nextStep_) + ": its data has the wrong size");
  if (nextStep_ - chunkStart_ >= hashes_.size() / 8) reject("chunk at step " + std::to_string(nextStep_) + ": missing");
}

bool SessionReader::next(StepInput& input, std::uint64_t& stateHash) {
  if (nextStep_ >= steps_) return false;
  if (nextStep_ - chunkStart_ >= hashes_.size() / 8) guarded([&] { loadChunk(); });
  const std::size_t i = nextStep_ - chunkStart_;
  input = decodeStepInput(std::span(inputs_).subspan(i * kStepInputBytes, kStepInputBytes));
  stateHash = decodeWord(std::span(hashes_).subspan(i * 8, 8));
  const std::string wrong = flaw(input);
  if (!wrong.empty()) reject("input of step " + std::to_string(nextStep_) + ": " + wrong);
  ++nextStep_;
  return true;
}

std::optional<std::vector<std::uint8_t>> SessionReader::stateAfter(std::uint64_t step) {
  std::optional<std::vector<std::uint8_t>> found;
  guarded([&] {
    Statement row = database_->prepare("SELECT content FROM state WHERE step=?");
    row.bind(1, static_cast<std::int64_t>(step));
    if (row.step()) found = row.blob(0);
  });
  return found;
}

std::optional<std::uint64_t> SessionReader::storedBefore(std::uint64_t step) {
  std::optional<std::uint64_t> found;
  guarded([&] {
    Statement row = database_->prepare("SELECT step FROM state WHERE step<=? ORDER BY step DESC LIMIT 1");
    row.bind(1, static_cast<std::int64_t>(step));
    if (row.step()) found = static_cast<std::uint64_t>(row.integer(0));
  });
  return found;
}

void SessionReader::seek(std::uint64_t step) {
  nextStep_ = step;
  inputs_.clear();
  hashes_.clear();
  chunkStart_ = step;
}

}  // namespace halsted::app
