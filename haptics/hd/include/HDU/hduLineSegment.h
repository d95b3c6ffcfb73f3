/* A straight piece between two points. */
#ifndef HALSTED_HDU_LINE_SEGMENT_H
#define HALSTED_HDU_LINE_SEGMENT_H

#include <HDU/hduVector.h>

#ifdef __cplusplus

template <class T>
class hduLineSegment {
 public:
  typedef hduVector3D<T> VecType;
  typedef T EltType;

  hduLineSegment() : m_begin(), m_end() {}
  hduLineSegment(const VecType &point1, const VecType &point2) : m_begin(point1), m_end(point2) {}

  const VecType &p1() const { return m_begin; }
  const VecType &p2() const { return m_end; }
  T length() const { return m_begin.distance(m_end); }
  VecType evalPoint(T t) const { return m_begin + (m_end - m_begin) * t; }

  /* The nearest point of the piece. */
  VecType projectPoint(const VecType &point) const {
    const VecType along = m_end - m_begin;
    const T square = along.dotProduct(along);
    if (!(square > T(0))) return m_begin;
    const T t = (point - m_begin).dotProduct(along) / square;
    return evalPoint(t < T(0) ? T(0) : t > T(1) ? T(1) : t);
  }
  T distance(const VecType &point) const { return projectPoint(point).distance(point); }

 private:
  VecType m_begin, m_end;
};

typedef hduLineSegment<HDdouble> hduLineSegmentd;
typedef hduLineSegment<HDfloat> hduLineSegmentf;

#endif

#endif
