/* A quaternion: scalar s, then vector v, in this order in memory. A rotation of hduMatrix (row vectors) and a quaternion that convert
   into one another turn a vector the same way. */
#ifndef HALSTED_HDU_QUATERNION_H
#define HALSTED_HDU_QUATERNION_H

#include <HDU/hduMatrix.h>

#ifdef __cplusplus

class hduQuaternion {
 public:
  hduQuaternion() : m_s(1.0), m_v() {}
  hduQuaternion(double s, const hduVector3Dd &v) : m_s(s), m_v(v) {}
  hduQuaternion(double s, double x, double y, double z) : m_s(s), m_v(x, y, z) {}
  hduQuaternion(const hduVector3Dd &axis, double radians) : m_s(1.0), m_v() { fromAxisAngle(axis, radians); }
  explicit hduQuaternion(const hduMatrix &rotation) : m_s(1.0), m_v() { fromRotationMatrix(rotation); }
  explicit hduQuaternion(const double values[4]) : m_s(values[0]), m_v(values[1], values[2], values[3]) {}

  double &s() { return m_s; }
  const double &s() const { return m_s; }
  hduVector3Dd &v() { return m_v; }
  const hduVector3Dd &v() const { return m_v; }
  operator double *() { return &m_s; }
  operator const double *() const { return &m_s; }

  double norm() const { return sqrt(m_s * m_s + m_v.dotProduct(m_v)); }
  hduQuaternion &normalize() {
    const double length = norm();
    return length > 0.0 ? (*this *= 1.0 / length) : *this;
  }
  hduQuaternion conjugate() const { return hduQuaternion(m_s, -m_v); }
  hduQuaternion inverse() const {
    const double square = norm() * norm();
    return square > 0.0 ? conjugate() *= 1.0 / square : conjugate();
  }

  hduQuaternion &operator*=(const hduQuaternion &q) {
    const double s = m_s * q.m_s - m_v.dotProduct(q.m_v);
    m_v = q.m_v * m_s + m_v * q.m_s + m_v.crossProduct(q.m_v);
    m_s = s;
    return *this;
  }
  hduQuaternion &operator*=(double scale) {
    m_s *= scale;
    m_v *= scale;
    return *this;
  }
  hduQuaternion &operator+=(const hduQuaternion &q) {
    m_s += q.m_s;
    m_v += q.m_v;
    return *this;
  }
  hduQuaternion &operator-=(const hduQuaternion &q) {
    m_s -= q.m_s;
    m_v -= q.m_v;
    return *this;
  }
  hduQuaternion operator-() const { return hduQuaternion(-m_s, -m_v); }

  void toAxisAngle(hduVector3Dd &axis, double &radians) const {
    const double length = m_v.magnitude();
    radians = 2.0 * atan2(length, m_s);
    axis = length > 0.0 ? m_v / length : hduVector3Dd(0.0, 0.0, 1.0);
  }
  void fromAxisAngle(const hduVector3Dd &axis, double radians) {
    const hduVector3Dd unit = ::normalize(axis);
    m_s = cos(radians / 2.0);
    m_v = unit * sin(radians / 2.0);
  }

  /* An array is for column vectors: v' = R v. */
  void toRotationMatrix(double R[3][3]) const;
  void fromRotationMatrix(const double R[3][3]);
  void toRotationMatrix(hduMatrix &rotation) const {
    double R[3][3];
    toRotationMatrix(R);
    rotation.makeIdentity();
    for (int i = 0; i < 9; ++i) rotation[i / 3][i % 3] = R[i % 3][i / 3];
  }
  void fromRotationMatrix(const hduMatrix &rotation) {
    double R[3][3];
    for (int i = 0; i < 9; ++i) R[i / 3][i % 3] = rotation[i % 3][i / 3];
    fromRotationMatrix(R);
  }

 private:
  double m_s;
  hduVector3Dd m_v;
};

inline void hduQuaternion::toRotationMatrix(double R[3][3]) const {
  const double w = m_s, x = m_v[0], y = m_v[1], z = m_v[2];
  const double square = w * w + x * x + y * y + z * z;
  const double k = square > 0.0 ? 2.0 / square : 0.0;
  R[0][0] = 1.0 - k * (y * y + z * z);
  R[0][1] = k * (x * y - w * z);
  R[0][2] = k * (x * z + w * y);
  R[1][0] = k * (x * y + w * z);
  R[1][1] = 1.0 - k * (x * x + z * z);
  R[1][2] = k * (y * z - w * x);
  R[2][0] = k * (x * z - w * y);
  R[2][1] = k * (y * z + w * x);
  R[2][2] = 1.0 - k * (x * x + y * y);
}

/* Shepperd (1978): from the largest of the four, so that nothing is divided by a small number. */
inline void hduQuaternion::fromRotationMatrix(const double R[3][3]) {
  const double trace = R[0][0] + R[1][1] + R[2][2];
  int largest = 0;
  for (int i = 1; i < 3; ++i)
    if (R[i][i] > R[largest][largest]) largest = i;
  const int i = largest, j = (i + 1) % 3, k = (i + 2) % 3;
  if (trace >= R[i][i]) {
    m_s = 0.5 * sqrt(1.0 + trace);
    m_v.set(R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]);
    m_v *= 0.25 / m_s;
    return;
  }
  const double size = 0.5 * sqrt(1.0 + R[i][i] - R[j][j] - R[k][k]);
  m_v[i] = size;
  m_v[j] = 0.25 / size * (R[j][i] + R[i][j]);
  m_v[k] = 0.25 / size * (R[k][i] + R[i][k]);
  m_s = 0.25 / size * (R[k][j] - R[j][k]);
  if (m_s < 0.0) *this *= -1.0; /* of the two that turn alike, the one with an angle of at most half a turn */
}

inline hduQuaternion operator*(const hduQuaternion &a, const hduQuaternion &b) { return hduQuaternion(a) *= b; }
inline hduQuaternion operator*(const hduQuaternion &q, double scale) { return hduQuaternion(q) *= scale; }
inline hduQuaternion operator*(double scale, const hduQuaternion &q) { return hduQuaternion(q) *= scale; }
inline hduQuaternion operator+(const hduQuaternion &a, const hduQuaternion &b) { return hduQuaternion(a) += b; }
inline hduQuaternion operator-(const hduQuaternion &a, const hduQuaternion &b) { return hduQuaternion(a) -= b; }

inline std::ostream &operator<<(std::ostream &os, const hduQuaternion &q) { return os << q.s() << " " << q.v(); }

/* Along the shorter arc, from a at t = 0 to b at t = 1. */
inline hduQuaternion hduSlerp(const hduQuaternion &a, const hduQuaternion &b, double t) {
  const double dot = a.s() * b.s() + a.v().dotProduct(b.v());
  const double side = dot < 0.0 ? -1.0 : 1.0;
  const double angle = acos(fabs(dot) < 1.0 ? fabs(dot) : 1.0);
  const double sine = sin(angle);
  if (!(sine > 1e-9)) return (a * (1.0 - t) + b * (t * side)).normalize();
  return a * (sin((1.0 - t) * angle) / sine) + b * (side * sin(t * angle) / sine);
}

inline void hduMatrix::getRotation(hduQuaternion &quaternion) const {
  hduMatrix rotation;
  getRotationMatrix(rotation);
  quaternion.fromRotationMatrix(rotation);
}

inline hduMatrix hduMatrix::createRotation(const hduQuaternion &quaternion) {
  hduMatrix out;
  quaternion.toRotationMatrix(out);
  return out;
}

inline hduMatrix hduMatrix::createRotationTranslation(const hduQuaternion &rotation, const hduVector3Dd &translation) {
  return createRotationTranslation(createRotation(rotation), translation);
}

#endif

#endif
