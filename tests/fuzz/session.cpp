/// Any bytes as a session file: refused with one line or read to the end, never a crash. Plain bytes rarely get past SQLite's own
/// checks, so the first byte also chooses to damage one table of a valid session with the rest.
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "app/session/database.h"
#include "app/session/session_reader.h"
#include "app/session/session_writer.h"
#include "scenes/scene.h"

using namespace halsted;
using namespace halsted::app;

namespace {

std::string scratchPath() { return "/dev/shm/halsted-fuzz-" + std::to_string(getpid()) + ".halsted"; }

void writeValid(const std::string& path) {
  SessionHeader header;
  header.scene = "purse_string";
  header.anatomy.mesh = blockMesh(1, 1, 1, Vec3(0.01, 0.01, 0.01));
  header.anatomy.mesh.uv.resize(header.anatomy.mesh.vertices.size(), Eigen::Vector2d::Zero());
  header.anatomy.mesh.triangleLayer.resize(header.anatomy.mesh.surface.size(), 0);
  SessionWriter writer(path, header);
  for (int i = 0; i < 4; ++i) writer.addStep({}, 1);
  writer.addState(2, {1, 2, 3});
  writer.close();
}

void damage(const std::string& path, std::uint8_t choice, std::span<const std::uint8_t> bytes) {
  const char* const statements[] = {"UPDATE anatomy SET content=?", "UPDATE start SET pose=?", "UPDATE chunk SET inputs=?",
                                    "UPDATE chunk SET hashes=?", "UPDATE meta SET value=CAST(? AS TEXT)",
                                    "UPDATE chunk SET count=CAST(CAST(? AS TEXT) AS INTEGER)", "UPDATE state SET content=?"};
  Database(path, Database::Mode::kRead).prepare(statements[choice % 7]).bind(1, bytes).run();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const std::string path = scratchPath();
  std::remove(path.c_str());
  if (data[0] < 128) {
    writeValid(path);
    damage(path, data[0], {data + 1, size - 1});
  } else if (FILE* file = std::fopen(path.c_str(), "wb")) {
    std::fwrite(data + 1, 1, size - 1, file);
    std::fclose(file);
  }
  try {
    SessionReader reader(path);
    StepInput input;
    std::uint64_t hash = 0;
    while (reader.next(input, hash)) {}
    (void)reader.stateAfter(2);
  } catch (const scenes::InputError& error) {
    if (std::string(error.what()).find(path) != 0) std::abort();   // every refusal names the file
  }
  std::remove(path.c_str());
  return 0;
}
