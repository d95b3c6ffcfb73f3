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
  hduPlane(const VecType &normal, const VecType &point) : m_normal(), m_d() { setPlane(normal, point); }
  hduPlane(const VecType &normal, T d) : m_normal(T(0), T(0), T(1)), m_d(d) {
    if (normal.magnitude() > T(0)) *this = hduPlane(normal[0], normal[1], normal[2], d);
  }

  void setPlane(const VecType &normal, const VecType &point) {
    m_normal = ::normalize(normal);
    m_d = -m_normal.dotProduct(point);
  }

  T a() const { return m_normal[0]; }
  T b() const { return m_normal[1]; }
  T c() const { return m_normal[2]; }
  T d() const { return m_d; }
  const VecType &normal() const { return m_normal; }
  /* Positive in front of the plane. */
  T perpDistance(const VecType &point) const { return m_normal.dotProduct(point) + m_d; }
  T distance(const VecType &point) const { return perpDistance(point); }
  VecType projectPoint(const VecType &point) const { return point - m_normal * perpDistance(point); }
  VecType pointOn() const { return m_normal * (-m_d); }

  /* From which side the segment or line comes to the plane, and where: `t` runs from 0 to 1 along a segment, in lengths of its direction
     along a line. What is parallel to the plane within epsilon does not meet it. */
  enum IntersectResult { ResultNone, ResultFront, ResultBack };
  IntersectResult intersectSegmentFront(const hduLineSegment<T> &segment, HDdouble &t, HDdouble epsilon) const {
    return only(ResultFront, intersectSegmentFrontAndBack(segment, t, epsilon));
  }
  IntersectResult intersectSegmentBack(const hduLineSegment<T> &segment, HDdouble &t, HDdouble epsilon) const {
    return only(ResultBack, intersectSegmentFrontAndBack(segment, t, epsilon));
  }
  IntersectResult intersectSegmentFrontAndBack(const hduLineSegment<T> &segment, HDdouble &t, HDdouble epsilon) const {
    HDdouble at = 0.0;
    const IntersectResult result = meet(segment.p1(), segment.p2() - segment.p1(), at, epsilon);
    if (result == ResultNone || at < -epsilon || at > 1.0 + epsilon) return ResultNone;
    t = at;
    return result;
  }
  IntersectResult intersectLineFront(const hduLine<T> &line, HDdouble &t, HDdouble epsilon) const {
    return only(ResultFront, intersectLineFrontAndBack(line, t, epsilon));
  }
  IntersectResult intersectLineBack(const hduLine<T> &line, HDdouble &t, HDdouble epsilon) const {
    return only(ResultBack, intersectLineFrontAndBack(line, t, epsilon));
  }
  IntersectResult intersectLineFrontAndBack(const hduLine<T> &line, HDdouble &t, HDdouble epsilon) const {
    return meet(line.p(), line.d(), t, epsilon);
  }

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
  static IntersectResult only(IntersectResult wanted, IntersectResult found) { return found == wanted ? found : ResultNone; }
  IntersectResult meet(const VecType &begin, const VecType &along, HDdouble &t, HDdouble epsilon) const {
    const HDdouble slope = static_cast<HDdouble>(m_normal.dotProduct(along));
    if (slope >= -epsilon && slope <= epsilon) return ResultNone;
    t = -static_cast<HDdouble>(perpDistance(begin)) / slope;
    return slope < 0.0 ? ResultFront : ResultBack;
  }

  VecType m_normal;
  T m_d;
};

typedef hduPlane<HDdouble> hduPlaned;
typedef hduPlane<HDfloat> hduPlanef;

#endif

#endif
