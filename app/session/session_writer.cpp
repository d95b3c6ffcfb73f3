#include "app/session/session_writer.h"

#include <sqlite3.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "app/errors.h"
#include "app/hexadecimal.h"
#include "app/session/mesh_codec.h"
#include "app/session/step_codec.h"
#include "scenes/scene.h"

namespace halsted::app {
namespace {

constexpr auto kCommitInterval = std::chrono::milliseconds(250);
constexpr std::size_t kChunkSteps = 4000;

std::string join(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string decimal(double value) {            // any unit; round-trips
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.17g", value);
  return digits;
}

/// Only an earlier session gives way: a mistyped path must not cost somebody a file.
void makeRoom(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return;
  std::ifstream in(path, std::ios::binary);
  char head[72] = {};
  in.read(head, sizeof head);
  const bool empty = in.gcount() == 0;
  const auto byte = [&](int i) { return static_cast<std::int64_t>(static_cast<unsigned char>(head[i])); };
  const std::int64_t magic = byte(68) << 24 | byte(69) << 16 | byte(70) << 8 | byte(71);   // application_id in SQLite's header
  if (!empty && !(std::string(head, 15) == "SQLite format 3" && magic == kSessionMagic))
    throw scenes::InputError(path + ": exists and is not a Halsted session; not overwritten");
  std::filesystem::remove(path, ignored);
  std::filesystem::remove(path + "-journal", ignored);
}

}  // namespace

template <typename Action>
void SessionWriter::guarded(Action action) {
  try {
    action();
  } catch (const DatabaseError& error) {
    throw SystemFault(path_ + ": cannot write the session: " + error.what);
  }
}

SessionWriter::SessionWriter(const std::string& path, const SessionHeader& header)
    : path_(path), lastCommit_(std::chrono::steady_clock::now()) {
  makeRoom(path);
  guarded([&] {
    database_ = std::make_unique<Database>(path, Database::Mode::kCreate);
    createTables();
    writeHeader(header);
    database_->execute("COMMIT; BEGIN");       // from here a transaction is always open; `commit` ends it and opens the next
  });
}

SessionWriter::~SessionWriter() {
  try {
    if (!closed_ && database_) commit();
  } catch (const std::exception&) {
    return;                                    // already reported where it can be; a destructor has nobody to tell
  }
}

void SessionWriter::createTables() {
  database_->execute("PRAGMA page_size=8192; PRAGMA journal_mode=DELETE; PRAGMA synchronous=NORMAL;");
  database_->execute("PRAGMA application_id=" + std::to_string(kSessionMagic) + "; PRAGMA user_version=" + std::to_string(kSessionFormat));
  database_->execute(
      "BEGIN;"
      "CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;"
      "CREATE TABLE parameter(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;"
      "CREATE TABLE anatomy(content BLOB NOT NULL, hash INTEGER NOT NULL);"
      "CREATE TABLE start(hand INTEGER PRIMARY KEY, pose BLOB NOT NULL);"
      "CREATE TABLE chunk(first_step INTEGER PRIMARY KEY, count INTEGER NOT NULL, inputs BLOB NOT NULL, hashes BLOB NOT NULL);"
      "CREATE TABLE event(step INTEGER NOT NULL, kind TEXT NOT NULL, hand INTEGER, idx INTEGER, value REAL);"
      "CREATE TABLE state(step INTEGER PRIMARY KEY, content BLOB NOT NULL);"
      "CREATE TABLE haptic(first_tick INTEGER NOT NULL, count INTEGER NOT NULL, records BLOB NOT NULL);");
}

void SessionWriter::writeHeader(const SessionHeader& header) {
  const std::pair<const char*, std::string> values[] = {
      {"scene", header.scene}, {"scene_text", header.sceneText}, {"expert_text", header.expertText},
      {"overrides", join(header.overrides)}, {"program", header.program}, {"created", header.created},
      {"trainee", header.trainee}, {"left_device", header.devices[kLeft]}, {"right_device", header.devices[kRight]},
      {"dt_s", decimal(header.dt)}, {"seed", std::to_string(header.seed)}, {"closed", "no"}};
  for (const auto& [key, value] : values) note(key, value);
  Statement parameter = database_->prepare("INSERT INTO parameter VALUES(?,?)");
  for (const std::string& entry : header.parameters) {
    const std::size_t equals = entry.find('=');
    parameter.bind(1, entry.substr(0, equals)).bind(2, entry.substr(equals + 1)).run();
  }
  const Blob anatomy = encodeAnatomy(header.anatomy);
  database_->prepare("INSERT INTO anatomy VALUES(?,?)").bind(1, std::span(anatomy)).bind(2, static_cast<std::int64_t>(contentHash(anatomy))).run();
  for (int hand = 0; hand < kHands; ++hand) {
    Blob pose;
    appendPose(header.start[hand], pose);
    database_->prepare("INSERT INTO start VALUES(?,?)").bind(1, std::int64_t{hand}).bind(2, std::span(pose)).run();
  }
}

void SessionWriter::note(const std::string& key, const std::string& value) {
  guarded([&] { database_->prepare("INSERT OR REPLACE INTO meta VALUES(?,?)").bind(1, key).bind(2, value).run(); });
}

void SessionWriter::addStep(const StepInput& input, std::uint64_t stateHash) {
  appendStepInput(input, inputs_);
  appendWord(stateHash, hashes_);
  lastHash_ = stateHash;
}

void SessionWriter::addHaptic(const HapticRecord& record) { haptic_.push_back(record); }

void SessionWriter::addEvent(const Event& event) {
  guarded([&] {
    database_->prepare("INSERT INTO event VALUES(?,?,?,?,?)")
        .bind(1, static_cast<std::int64_t>(event.step)).bind(2, std::string(name(event.kind)))
        .bind(3, std::int64_t{event.hand}).bind(4, std::int64_t{event.index}).bind(5, event.value).run();
  });
}

void SessionWriter::addState(std::uint64_t step, const std::vector<std::uint8_t>& saved) {
  guarded([&] {
    database_->prepare("INSERT OR REPLACE INTO state VALUES(?,?)")
        .bind(1, static_cast<std::int64_t>(step)).bind(2, std::span(saved)).run();
  });
}

/// What is in the transaction is gathered no longer: a commit that fails must not write it twice.
void SessionWriter::insertGathered() {
  if (!hashes_.empty()) {
    const std::size_t count = hashes_.size() / 8;
    database_->prepare("INSERT INTO chunk VALUES(?,?,?,?)")
        .bind(1, static_cast<std::int64_t>(firstStep_)).bind(2, static_cast<std::int64_t>(count))
        .bind(3, std::span(inputs_)).bind(4, std::span(hashes_)).run();
    firstStep_ += count;
    inputs_.clear();
    hashes_.clear();
  }
  if (!haptic_.empty()) {
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(haptic_.data()), haptic_.size() * sizeof(HapticRecord));
    database_->prepare("INSERT INTO haptic VALUES(?,?,?)")
        .bind(1, static_cast<std::int64_t>(haptic_.front().tick)).bind(2, static_cast<std::int64_t>(haptic_.size()))
        .bind(3, bytes).run();
    haptic_.clear();
  }
}

bool SessionWriter::commit() {
  bool done = true;
  guarded([&] {
    insertGathered();
    try {
      database_->execute("COMMIT; BEGIN");
    } catch (const DatabaseError& error) {
      if (error.code != SQLITE_BUSY) throw;
      done = false;
    }
  });
  lastCommit_ = std::chrono::steady_clock::now();
  return done;
}

void SessionWriter::commitWhenDue() {
  if (hashes_.size() / 8 >= kChunkSteps || std::chrono::steady_clock::now() - lastCommit_ >= kCommitInterval) commit();
}

void SessionWriter::close() {
  if (steps() > 0) note("state_hash", hexadecimal(lastHash_));
  note("closed", "yes");
  if (!commit()) throw SystemFault(path_ + ": cannot write the session: somebody holds the file");
  closed_ = true;
}

}  // namespace halsted::app
