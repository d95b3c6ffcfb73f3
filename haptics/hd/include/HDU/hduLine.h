/* A line through a point along a direction. */
#ifndef HALSTED_HDU_LINE_H
#define HALSTED_HDU_LINE_H

#include <HDU/hduVector.h>

#ifdef __cplusplus

template <class T>
class hduLine {
 public:
  typedef hduVector3D<T> VecType;
  typedef T EltType;

  hduLine() : m_point(), m_direction(T(0), T(0), T(1)) {}
  hduLine(const VecType &point1, const VecType &point2) : m_point(point1), m_direction(::normalize(VecType(point2 - point1))) {}

  const VecType &p() const { return m_point; }
  const VecType &d() const { return m_direction; }
  const VecType &point() const { return m_point; }
  const VecType &direction() const { return m_direction; }
  /* The sine of the angle between the two is at most epsilon. */
  bool isParallel(const hduLine &other, HDdouble epsilon) const {
    return static_cast<HDdouble>(m_direction.crossProduct(other.m_direction).magnitude()) <= epsilon;
  }
  VecType evalPoint(T t) const { return m_point + m_direction * t; }
  VecType projectPoint(const VecType &point) const { return evalPoint((point - m_point).dotProduct(m_direction)); }
  T distance(const VecType &point) const { return projectPoint(point).distance(point); }

 private:
  VecType m_point, m_direction;
};

typedef hduLine<HDdouble> hduLined;
typedef hduLine<HDfloat> hduLinef;

#endif

#endif
