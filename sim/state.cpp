#include "sim/state.h"

#include <bit>
#include <cstdio>
#include <cstring>

#include "sim/fields.h"

namespace halsted {

std::string FieldPath::text() const {
  std::string out;
  for (int d = 0; d < depth_; ++d) {
    const Entry& entry = entries_[d];
    const std::string list = entry.names;
    std::size_t begin = 0;
    for (int m = 0; m < entry.member; ++m) begin = list.find(',', begin) + 1;
    begin = list.find_first_not_of(' ', begin);
    if (d > 0) out += '.';
    out += list.substr(begin, list.find(',', begin) - begin);
    if (entry.index >= 0) out.append("[").append(std::to_string(entry.index)).append("]");
  }
  return out;
}

namespace {

/// FNV-1a (Fowler, Noll, Vo) taken eight bytes at a time. Each round is a bijection of the sum, so one changed scalar always changes
/// the hash; the fold brings high bits down, or two flipped signs would cancel. Long runs go in four lanes: byte by byte the hash of
/// a 200 kB state would cost 0.25 ms of every 1 ms step.
class Hasher {
 public:
  template <class T> void leaf(const FieldPath&, const T* data, std::size_t count, int) {
    const T* const end = data + count;
    if (count >= 32) {
      std::uint64_t lane[4] = {sum_ ^ 1, sum_ ^ 2, sum_ ^ 3, sum_ ^ 4};
      for (; end - data >= 4; data += 4)
        for (int k = 0; k < 4; ++k) lane[k] = mix(lane[k], word(data[k]));
      for (std::uint64_t l : lane) sum_ = mix(sum_, l);
    }
    for (; data != end; ++data) sum_ = mix(sum_, word(*data));
  }
  void size(const FieldPath&, std::size_t length) { sum_ = mix(sum_, length); }
  std::uint64_t sum() const { return sum_; }

 private:
  template <class T> static std::uint64_t word(T x) {
    if constexpr (std::is_same_v<T, double>) return std::bit_cast<std::uint64_t>(x);
    else return static_cast<std::uint64_t>(x);
  }
  static std::uint64_t mix(std::uint64_t sum, std::uint64_t x) {
    sum = (sum ^ x) * 0x100000001b3ULL;
    return sum ^ (sum >> 32);
  }
  std::uint64_t sum_ = 0xcbf29ce484222325ULL;
};

struct Saver {
  std::vector<std::uint8_t>& bytes;

  template <class T> void leaf(const FieldPath&, const T* data, std::size_t count, int) {
    const auto* from = reinterpret_cast<const std::uint8_t*>(data);
    bytes.insert(bytes.end(), from, from + count * sizeof(T));
  }
  void size(const FieldPath&, std::size_t length) {
    const std::uint64_t stored = length;
    leaf({}, &stored, 1, 1);
  }
};

struct Loader {
  const std::vector<std::uint8_t>& bytes;
  std::string& error;
  std::size_t at = 0;

  template <class T> void leaf(const FieldPath& path, T* data, std::size_t count, int) {
    if (!error.empty()) return;
    const std::size_t length = count * sizeof(T);
    if (bytes.size() - at < length) { error = path.text() + ": the data ends here"; return; }
    if constexpr (std::is_same_v<T, bool>) {
      for (std::size_t i = 0; i < count; ++i)
        if (bytes[at + i] > 1) { error = path.text() + ": neither true nor false"; return; }
    }
    std::memcpy(data, bytes.data() + at, length);
    at += length;
  }
  void size(const FieldPath& path, std::size_t length) {
    std::uint64_t stored = 0;
    leaf(path, &stored, 1, 1);
    if (error.empty() && stored != length)
      error = path.text() + ": " + std::to_string(stored) + " items in the data, " + std::to_string(length) + " in this scene";
  }
};

/// Names the scalar that holds byte `target` of the saved form and prints it from both savings.
struct DiffFinder {
  std::size_t target;
  const std::vector<std::uint8_t>& a;
  const std::vector<std::uint8_t>& b;
  std::string text;
  std::size_t at = 0;

  template <class T> void leaf(const FieldPath& path, const T*, std::size_t count, int stride) {
    if (text.empty() && target < at + count * sizeof(T)) {
      const std::size_t i = (target - at) / sizeof(T);
      text = path.text();
      if (count > static_cast<std::size_t>(stride)) text.append("[").append(std::to_string(i / stride)).append("]");
      if (stride > 1) text.append(1, '.').append(1, "xyzw"[i % stride]);
      text.append(": ").append(print<T>(a, at + i * sizeof(T))).append(" and ").append(print<T>(b, at + i * sizeof(T)));
    }
    at += count * sizeof(T);
  }
  void size(const FieldPath& path, std::size_t) {
    if (text.empty() && target < at + 8)
      text = path.text() + ".size: " + print<std::uint64_t>(a, at) + " and " + print<std::uint64_t>(b, at);
    at += 8;
  }

 private:
  template <class T> static std::string print(const std::vector<std::uint8_t>& bytes, std::size_t from) {
    if (from + sizeof(T) > bytes.size()) return "nothing";
    if constexpr (std::is_same_v<T, bool>) return bytes[from] ? "true" : "false";
    else {
      T value{};
      std::memcpy(&value, bytes.data() + from, sizeof(T));
      if constexpr (std::is_integral_v<T>) return std::to_string(value);
      else {
        char digits[32];                     // 17 digits: two doubles that differ never print alike
        std::snprintf(digits, sizeof digits, "%.17g", value);
        return digits;
      }
    }
  }
};

// The list takes a mutable state because `load` writes through it; the other visitors only read.
State& readable(const State& state) { return const_cast<State&>(state); }

}  // namespace

std::uint64_t hash(const State& state) {
  Hasher hasher;
  visitFields(readable(state), hasher);
  return hasher.sum();
}

std::vector<std::uint8_t> save(const State& state) {
  std::vector<std::uint8_t> bytes;
  Saver saver{bytes};
  visitFields(readable(state), saver);
  return bytes;
}

bool load(const std::vector<std::uint8_t>& bytes, State& state, std::string& error) {
  error.clear();
  State copy = state;                        // a state is restored whole or not at all
  Loader loader{bytes, error};
  visitFields(copy, loader);
  if (error.empty() && loader.at != bytes.size()) error = "more data than this scene's state holds";
  if (!error.empty()) return false;
  copy.work = std::move(state.work);         // scratch keeps the room that was set aside for it: a copy would not
  state = std::move(copy);
  if (state.cut)
    for (NearPairs& list : state.work.self.nearby) list.whole = false;   // of faces that another cut laid bare
  return true;
}

std::string diff(const State& a, const State& b) {
  const std::vector<std::uint8_t> left = save(a), right = save(b);
  std::size_t i = 0;
  while (i < left.size() && i < right.size() && left[i] == right[i]) ++i;
  if (i == left.size() && i == right.size()) return {};
  DiffFinder finder{i, left, right, {}};
  visitFields(readable(a), finder);
  return finder.text;
}

}  // namespace halsted
