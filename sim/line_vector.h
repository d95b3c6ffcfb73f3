#pragma once
/// Vectors that begin with a cache line, for what is read four doubles at a time: a row of four that lies in two lines costs twice. Speed only,
/// never bits.
#include <new>
#include <vector>

namespace halsted {

template <typename T> struct CacheLines {
  using value_type = T;
  static constexpr std::align_val_t kLine{64};   // bytes

  CacheLines() = default;
  template <typename U> CacheLines(const CacheLines<U>&) {}
  T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), kLine)); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, kLine); }
  friend bool operator==(const CacheLines&, const CacheLines&) { return true; }
};

template <typename T> using LineVector = std::vector<T, CacheLines<T>>;

}  // namespace halsted
