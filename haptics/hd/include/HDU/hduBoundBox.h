/* The smallest box along the axes that holds the points given to Union. */
#ifndef HALSTED_HDU_BOUND_BOX_H
#define HALSTED_HDU_BOUND_BOX_H

#include <HDU/hduVector.h>

#ifdef __cplusplus

template <class T>
class hduBoundBox3D {
 public:
  typedef T PointType;

  hduBoundBox3D() : m_lo(), m_hi(), m_empty(true) {}
  hduBoundBox3D(const T &lo, const T &hi) : m_lo(), m_hi(), m_empty(true) {
    Union(lo);
    Union(hi);
  }

  bool isEmpty() const { return m_empty; }
  void makeEmpty() { m_empty = true; }
  const T &lo() const { return m_lo; }
  const T &hi() const { return m_hi; }
  T &rLo() { return m_lo; }
  T &rHi() { return m_hi; }

  void Union(const T &point) {
    for (int i = 0; i < 3; ++i) {
      if (m_empty || point[i] < m_lo[i]) m_lo[i] = point[i];
      if (m_empty || point[i] > m_hi[i]) m_hi[i] = point[i];
    }
    m_empty = false;
  }
  void Union(const hduBoundBox3D &box) {
    if (box.m_empty) return;
    Union(box.m_lo);
    Union(box.m_hi);
  }
  bool contains(const T &point) const {
    for (int i = 0; i < 3; ++i)
      if (m_empty || point[i] < m_lo[i] || point[i] > m_hi[i]) return false;
    return true;
  }

 private:
  T m_lo, m_hi;
  bool m_empty;
};

typedef hduBoundBox3D<hduVector3Df> hduBoundBox3Df;
typedef hduBoundBox3D<hduVector3Dd> hduBoundBox3Dd;

#endif

#endif
