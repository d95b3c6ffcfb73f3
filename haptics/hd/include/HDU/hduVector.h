/* Vectors of three. C++: a class template; C: an array of three doubles; both: functions on three doubles. */
#ifndef HALSTED_HDU_VECTOR_H
#define HALSTED_HDU_VECTOR_H

#include <math.h>

#include <HD/hdDefines.h>
#include <HDU/hduVecFunctions.h>

#ifndef __cplusplus
typedef HDdouble hduVector3Dd[3];
typedef HDfloat hduVector3Df[3];
#else

#include <ostream>

template <class T>
class hduVector3D {
 public:
  typedef T EltType;

  hduVector3D() : m_elements() {}
  hduVector3D(T x, T y, T z) { set(x, y, z); }
  explicit hduVector3D(const T values[3]) { set(values[0], values[1], values[2]); }
  template <class U>
  hduVector3D(const hduVector3D<U> &other) {
    set(static_cast<T>(other[0]), static_cast<T>(other[1]), static_cast<T>(other[2]));
  }

  void set(T x, T y, T z) {
    m_elements[0] = x;
    m_elements[1] = y;
    m_elements[2] = z;
  }

  /* Any integer: with a fixed type an index of type long would be ambiguous with the conversion to T*. */
  template <class Index> T &operator[](Index i) { return m_elements[i]; }
  template <class Index> const T &operator[](Index i) const { return m_elements[i]; }
  operator T *() { return m_elements; }
  operator const T *() const { return m_elements; }

  template <class U>
  hduVector3D &operator=(const hduVector3D<U> &other) {
    set(static_cast<T>(other[0]), static_cast<T>(other[1]), static_cast<T>(other[2]));
    return *this;
  }
  hduVector3D &operator=(const T values[3]) {
    set(values[0], values[1], values[2]);
    return *this;
  }

  hduVector3D &operator+=(const hduVector3D &v) { return assign(m_elements[0] + v[0], m_elements[1] + v[1], m_elements[2] + v[2]); }
  hduVector3D &operator-=(const hduVector3D &v) { return assign(m_elements[0] - v[0], m_elements[1] - v[1], m_elements[2] - v[2]); }
  hduVector3D &operator*=(const hduVector3D &v) { return assign(m_elements[0] * v[0], m_elements[1] * v[1], m_elements[2] * v[2]); }
  hduVector3D &operator/=(const hduVector3D &v) { return assign(m_elements[0] / v[0], m_elements[1] / v[1], m_elements[2] / v[2]); }
  hduVector3D &operator+=(T s) { return assign(m_elements[0] + s, m_elements[1] + s, m_elements[2] + s); }
  hduVector3D &operator-=(T s) { return assign(m_elements[0] - s, m_elements[1] - s, m_elements[2] - s); }
  hduVector3D &operator*=(T s) { return assign(m_elements[0] * s, m_elements[1] * s, m_elements[2] * s); }
  hduVector3D &operator/=(T s) { return assign(m_elements[0] / s, m_elements[1] / s, m_elements[2] / s); }
  hduVector3D operator-() const { return hduVector3D(-m_elements[0], -m_elements[1], -m_elements[2]); }

  /* Every element within epsilon. */
  bool isZero(T epsilon) const { return inside(m_elements[0], epsilon) && inside(m_elements[1], epsilon) && inside(m_elements[2], epsilon); }
  bool compare(const hduVector3D &other, T epsilon) const { return (hduVector3D(*this) -= other).isZero(epsilon); }

  T distance(const hduVector3D &other) const { return (hduVector3D(*this) -= other).magnitude(); }
  T distanceSqr(const hduVector3D &other) const { return (hduVector3D(*this) -= other).magnitudeSqr(); }
  T magnitude() const { return static_cast<T>(sqrt(static_cast<double>(magnitudeSqr()))); }
  T magnitudeSqr() const { return dotProduct(*this); }

  /* A vector of length zero stays as it is. Returns this vector. */
  hduVector3D &normalize() {
    const T length = magnitude();
    return length > T(0) ? (*this /= length) : *this;
  }
  T dotProduct(const hduVector3D &v) const { return m_elements[0] * v[0] + m_elements[1] * v[1] + m_elements[2] * v[2]; }
  hduVector3D crossProduct(const hduVector3D &v) const {
    return hduVector3D(m_elements[1] * v[2] - m_elements[2] * v[1], m_elements[2] * v[0] - m_elements[0] * v[2],
                       m_elements[0] * v[1] - m_elements[1] * v[0]);
  }

  /* Which axis has the element that is largest, in between, smallest without its sign. */
  int getLongestAxisComponent() const { return axisOfRank(0); }
  int getSecondLongestAxisComponent() const { return axisOfRank(1); }
  int getShortestAxisComponent() const { return axisOfRank(2); }

 private:
  hduVector3D &assign(T x, T y, T z) {
    set(x, y, z);
    return *this;
  }
  static T size(T value) { return value < T(0) ? -value : value; }
  static bool inside(T value, T epsilon) { return size(value) <= epsilon; }
  int axisOfRank(int rank) const {
    int order[3] = {0, 1, 2};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2 - i; ++j)
        if (size(m_elements[order[j]]) < size(m_elements[order[j + 1]])) {
          const int swapped = order[j];
          order[j] = order[j + 1];
          order[j + 1] = swapped;
        }
    return order[rank];
  }

  T m_elements[3];
};

template <class T> hduVector3D<T> operator+(const hduVector3D<T> &a, const hduVector3D<T> &b) { return hduVector3D<T>(a) += b; }
template <class T> hduVector3D<T> operator-(const hduVector3D<T> &a, const hduVector3D<T> &b) { return hduVector3D<T>(a) -= b; }
template <class T> hduVector3D<T> operator*(const hduVector3D<T> &a, const hduVector3D<T> &b) { return hduVector3D<T>(a) *= b; }
template <class T> hduVector3D<T> operator/(const hduVector3D<T> &a, const hduVector3D<T> &b) { return hduVector3D<T>(a) /= b; }

/* With a scalar of any number type: an overload each, because deduction does not convert. */
#define HALSTED_HDU_SCALAR(S)                                                                                                        \
  template <class T> hduVector3D<T> operator+(const hduVector3D<T> &v, S s) { return hduVector3D<T>(v) += static_cast<T>(s); }      \
  template <class T> hduVector3D<T> operator-(const hduVector3D<T> &v, S s) { return hduVector3D<T>(v) -= static_cast<T>(s); }      \
  template <class T> hduVector3D<T> operator*(const hduVector3D<T> &v, S s) { return hduVector3D<T>(v) *= static_cast<T>(s); }      \
  template <class T> hduVector3D<T> operator/(const hduVector3D<T> &v, S s) { return hduVector3D<T>(v) /= static_cast<T>(s); }      \
  template <class T> hduVector3D<T> operator*(S s, const hduVector3D<T> &v) { return hduVector3D<T>(v) *= static_cast<T>(s); }      \
  template <class T> hduVector3D<T> operator+(S s, const hduVector3D<T> &v) { return hduVector3D<T>(v) += static_cast<T>(s); }
HALSTED_HDU_SCALAR(int)
HALSTED_HDU_SCALAR(long)
HALSTED_HDU_SCALAR(unsigned)
HALSTED_HDU_SCALAR(unsigned long)
HALSTED_HDU_SCALAR(float)
HALSTED_HDU_SCALAR(double)
#undef HALSTED_HDU_SCALAR

template <class T> bool operator==(const hduVector3D<T> &a, const hduVector3D<T> &b) { return a.compare(b, T(0)); }
template <class T> bool operator!=(const hduVector3D<T> &a, const hduVector3D<T> &b) { return !(a == b); }

template <class T> T dotProduct(const hduVector3D<T> &a, const hduVector3D<T> &b) { return a.dotProduct(b); }
template <class T> hduVector3D<T> crossProduct(const hduVector3D<T> &a, const hduVector3D<T> &b) { return a.crossProduct(b); }
template <class T> hduVector3D<T> normalize(const hduVector3D<T> &v) { return hduVector3D<T>(v).normalize(); }

template <class T> std::ostream &operator<<(std::ostream &os, const hduVector3D<T> &v) {
  return os << v[0] << " " << v[1] << " " << v[2];
}

typedef hduVector3D<HDfloat> hduVector3Df;
typedef hduVector3D<HDdouble> hduVector3Dd;

#endif

#endif
