/* A plane a x + b y + c z + d = 0 with (a, b, c) of length one. */
#ifndef HALSTED_HDU_PLANE_H
#define HALSTED_HDU_PLANE_H

#include <HDU/hduLine.h>
#include <HDU/hduLineSegment.h>
#include <HDU/hduVector.h>

#ifdef __cplusplus

template <class T>
class hduPlane {
 public:
  typedef hduVector3D<T> VecType;
  typedef T EltType;

  hduPlane() : m_normal(T(0), T(0), T(1)), m_d(T(0)) {}
  hduPlane(T a, T b, T c, T d) : m_normal(a, b, c), m_d(d) {
    const T length = m_normal.magnitude();
    if (!(length > T(0))) return;
    m_normal /= length;
    m_d /= length;
  }
  /* Counter-clockwise seen from the front. */
  hduPlane(const VecType &p1, const VecType &p2, const VecType &p3)
      : m_normal(::normalize(VecType(VecType(p2 - p1).crossProduct(VecType(p3 - p1))))), m_d(-m_normal.dotProduct(p1)) {}
  hduPlane(const VecType &normal, const VecType &point) : m_normal(::normalize(normal)), m_d(-m_normal.dotProduct(point)) {}

  const VecType &normal() const { return m_normal; }
  T d() const { return m_d; }
  /* Positive in front of the plane. */
  T perpDistance(const VecType &point) const { return m_normal.dotProduct(point) + m_d; }
  T distance(const VecType &point) const { return perpDistance(point); }
  VecType projectPoint(const VecType &point) const { return point - m_normal * perpDistance(point); }
  VecType pointOn() const { return m_normal * (-m_d); }

  bool intersectSegment(const hduLineSegment<T> &segment, VecType &point) const {
    const T begin = perpDistance(segment.p1()), end = perpDistance(segment.p2());
    if (begin * end > T(0) || begin == end) return false;
    point = segment.evalPoint(begin / (begin - end));
    return true;
  }
  bool intersectLine(const hduLine<T> &line, VecType &point) const {
    const T slope = m_normal.dotProduct(line.d());
    if (slope == T(0)) return false;
    point = line.evalPoint(-perpDistance(line.p()) / slope);
    return true;
  }

 private:
  VecType m_normal;
  T m_d;
};

typedef hduPlane<HDdouble> hduPlaned;
typedef hduPlane<HDfloat> hduPlanef;

#endif

#endif
