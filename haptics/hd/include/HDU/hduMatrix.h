/* A 4x4 of doubles for row vectors: v' = v M, translation in the last row, in memory row after row. That is the column-major matrix of
   HD_CURRENT_TRANSFORM and of OpenGL, number for number: hdGetDoublev(HD_CURRENT_TRANSFORM, matrix) needs no transposition. */
#ifndef HALSTED_HDU_MATRIX_H
#define HALSTED_HDU_MATRIX_H

#include <HDU/hduVector.h>

#ifdef __cplusplus

class hduQuaternion;

class hduMatrix {
 public:
  hduMatrix() { makeIdentity(); }
  hduMatrix(double a00, double a01, double a02, double a03, double a10, double a11, double a12, double a13, double a20, double a21,
            double a22, double a23, double a30, double a31, double a32, double a33);
  hduMatrix(const double values[16]) { fill(values); }
  explicit hduMatrix(const float values[16]) { fill(values); }
  explicit hduMatrix(const double values[4][4]) { set(values); }

  void set(const double values[4][4]) { fill(&values[0][0]); }
  void set(int row, int column, double value) { m_elements[row][column] = value; }
  void get(double values[4][4]) const;
  double get(int row, int column) const { return m_elements[row][column]; }

  template <class Index> double *operator[](Index row) { return m_elements[row]; }
  template <class Index> const double *operator[](Index row) const { return m_elements[row]; }
  double &operator()(int row, int column) { return m_elements[row][column]; }
  const double &operator()(int row, int column) const { return m_elements[row][column]; }
  operator double *() { return &m_elements[0][0]; }
  operator const double *() const { return &m_elements[0][0]; }

  void makeIdentity();
  /* Every element within epsilon. */
  bool isIdentity(double epsilon = 1e-9) const;
  bool compare(const hduMatrix &other, double epsilon) const;

  hduMatrix &operator+=(const hduMatrix &other);
  hduMatrix &operator-=(const hduMatrix &other);
  hduMatrix &operator*=(const hduMatrix &other) { return multRight(other); }
  hduMatrix &operator*=(double scale);
  /* this = this M and this = M this */
  hduMatrix &multRight(const hduMatrix &m) { return *this = product(*this, m); }
  hduMatrix &multLeft(const hduMatrix &m) { return *this = product(m, *this); }

  /* v M and M v of points (with the division by the fourth coordinate), then of directions (no translation). */
  void multVecMatrix(const hduVector3Dd &src, hduVector3Dd &dst) const;
  void multMatrixVec(const hduVector3Dd &src, hduVector3Dd &dst) const;
  void multDirMatrix(const hduVector3Dd &src, hduVector3Dd &dst) const;
  void multMatrixDir(const hduVector3Dd &src, hduVector3Dd &dst) const;

  hduMatrix getTranspose() const;
  hduMatrix &transpose() { return *this = getTranspose(); }
  double determinant() const;
  /* A singular matrix has none: then the flag is false and the answer is the matrix itself. */
  hduMatrix getInverse(bool &success) const;
  hduMatrix getInverse() const;
  bool invert();

  /* The nearest pure rotation: scale and shear taken away. */
  void getRotationMatrix(hduMatrix &rotation) const;
  void getRotation(hduQuaternion &quaternion) const;

  static hduMatrix createTranslation(const hduVector3Dd &t) { return createTranslation(t[0], t[1], t[2]); }
  static hduMatrix createTranslation(double x, double y, double z);
  static hduMatrix createScale(const hduVector3Dd &s) { return createScale(s[0], s[1], s[2]); }
  static hduMatrix createScale(double x, double y, double z);
  /* Radians about an axis, right-handed. */
  static hduMatrix createRotation(const hduVector3Dd &axis, double radians);
  static hduMatrix createRotation(double x, double y, double z, double radians) {
    return createRotation(hduVector3Dd(x, y, z), radians);
  }
  static hduMatrix createRotation(const hduQuaternion &quaternion);
  static hduMatrix createRotationAroundX(double radians) { return createRotation(1.0, 0.0, 0.0, radians); }
  static hduMatrix createRotationAroundY(double radians) { return createRotation(0.0, 1.0, 0.0, radians); }
  static hduMatrix createRotationAroundZ(double radians) { return createRotation(0.0, 0.0, 1.0, radians); }
  static hduMatrix createRotationTranslation(const hduMatrix &rotation, const hduVector3Dd &translation);
  static hduMatrix createRotationTranslation(const hduQuaternion &rotation, const hduVector3Dd &translation);

 private:
  template <class T> void fill(const T *values) {
    for (int i = 0; i < 16; ++i) m_elements[i / 4][i % 4] = static_cast<double>(values[i]);
  }
  static hduMatrix product(const hduMatrix &a, const hduMatrix &b);
  void transform(const hduVector3Dd &src, double w, hduVector3Dd &dst) const;

  double m_elements[4][4];
};

#include <HDU/hduMatrixInline.h>

inline hduMatrix operator*(const hduMatrix &a, const hduMatrix &b) { return hduMatrix(a).multRight(b); }
inline hduMatrix operator+(const hduMatrix &a, const hduMatrix &b) { return hduMatrix(a) += b; }
inline hduMatrix operator-(const hduMatrix &a, const hduMatrix &b) { return hduMatrix(a) -= b; }
inline hduMatrix operator*(const hduMatrix &m, double scale) { return hduMatrix(m) *= scale; }
inline hduMatrix operator*(double scale, const hduMatrix &m) { return hduMatrix(m) *= scale; }
inline bool operator==(const hduMatrix &a, const hduMatrix &b) { return a.compare(b, 0.0); }
inline bool operator!=(const hduMatrix &a, const hduMatrix &b) { return !a.compare(b, 0.0); }

template <class T> inline hduVector3D<T> operator*(const hduVector3D<T> &v, const hduMatrix &m) {
  hduVector3Dd moved;
  m.multVecMatrix(v, moved);
  return moved;
}
template <class T> inline hduVector3D<T> operator*(const hduMatrix &m, const hduVector3D<T> &v) {
  hduVector3Dd moved;
  m.multMatrixVec(v, moved);
  return moved;
}

inline std::ostream &operator<<(std::ostream &os, const hduMatrix &m) {
  for (int row = 0; row < 4; ++row) os << m[row][0] << " " << m[row][1] << " " << m[row][2] << " " << m[row][3] << "\n";
  return os;
}

#include <HDU/hduQuaternion.h>

#endif

#endif
