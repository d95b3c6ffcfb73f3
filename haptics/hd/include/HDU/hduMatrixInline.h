/* Bodies of hduMatrix; included by hduMatrix.h. Inline, so that any compiler and standard library of the client's will do. */
#ifndef HALSTED_HDU_MATRIX_INLINE_H
#define HALSTED_HDU_MATRIX_INLINE_H

#ifdef __cplusplus

inline hduMatrix::hduMatrix(double a00, double a01, double a02, double a03, double a10, double a11, double a12, double a13, double a20,
                            double a21, double a22, double a23, double a30, double a31, double a32, double a33) {
  const double values[16] = {a00, a01, a02, a03, a10, a11, a12, a13, a20, a21, a22, a23, a30, a31, a32, a33};
  fill(values);
}

inline void hduMatrix::get(double values[4][4]) const {
  for (int i = 0; i < 16; ++i) values[i / 4][i % 4] = m_elements[i / 4][i % 4];
}

inline void hduMatrix::makeIdentity() {
  for (int i = 0; i < 16; ++i) m_elements[i / 4][i % 4] = i % 5 == 0 ? 1.0 : 0.0;
}

inline bool hduMatrix::isIdentity(double epsilon) const { return compare(hduMatrix(), epsilon); }

inline bool hduMatrix::compare(const hduMatrix &other, double epsilon) const {
  for (int i = 0; i < 16; ++i)
    if (!(fabs(m_elements[i / 4][i % 4] - other.m_elements[i / 4][i % 4]) <= epsilon)) return false;
  return true;
}

inline hduMatrix &hduMatrix::operator+=(const hduMatrix &other) {
  for (int i = 0; i < 16; ++i) m_elements[i / 4][i % 4] += other.m_elements[i / 4][i % 4];
  return *this;
}

inline hduMatrix &hduMatrix::operator-=(const hduMatrix &other) {
  for (int i = 0; i < 16; ++i) m_elements[i / 4][i % 4] -= other.m_elements[i / 4][i % 4];
  return *this;
}

inline hduMatrix &hduMatrix::operator*=(double scale) {
  for (int i = 0; i < 16; ++i) m_elements[i / 4][i % 4] *= scale;
  return *this;
}

inline hduMatrix hduMatrix::product(const hduMatrix &a, const hduMatrix &b) {
  hduMatrix out;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      out.m_elements[i][j] = a.m_elements[i][0] * b.m_elements[0][j] + a.m_elements[i][1] * b.m_elements[1][j] +
                             a.m_elements[i][2] * b.m_elements[2][j] + a.m_elements[i][3] * b.m_elements[3][j];
  return out;
}

/* (src, w) M, divided by its fourth coordinate when w is one. */
inline void hduMatrix::transform(const hduVector3Dd &src, double w, hduVector3Dd &dst) const {
  double out[4];
  for (int j = 0; j < 4; ++j)
    out[j] = src[0] * m_elements[0][j] + src[1] * m_elements[1][j] + src[2] * m_elements[2][j] + w * m_elements[3][j];
  const double by = w != 0.0 && out[3] != 0.0 ? out[3] : 1.0;
  dst.set(out[0] / by, out[1] / by, out[2] / by);
}

inline void hduMatrix::multVecMatrix(const hduVector3Dd &src, hduVector3Dd &dst) const { transform(src, 1.0, dst); }
inline void hduMatrix::multDirMatrix(const hduVector3Dd &src, hduVector3Dd &dst) const { transform(src, 0.0, dst); }
inline void hduMatrix::multMatrixVec(const hduVector3Dd &src, hduVector3Dd &dst) const { getTranspose().transform(src, 1.0, dst); }
inline void hduMatrix::multMatrixDir(const hduVector3Dd &src, hduVector3Dd &dst) const { getTranspose().transform(src, 0.0, dst); }

inline hduMatrix hduMatrix::getTranspose() const {
  hduMatrix out;
  for (int i = 0; i < 16; ++i) out.m_elements[i % 4][i / 4] = m_elements[i / 4][i % 4];
  return out;
}

/* Gauss-Jordan with row pivots; the determinant is the product of the pivots. */
inline hduMatrix hduMatrix::getInverse(bool &success) const {
  hduMatrix left(*this), right;
  for (int column = 0; column < 4; ++column) {
    int pivot = column;
    for (int row = column + 1; row < 4; ++row)
      if (fabs(left.m_elements[row][column]) > fabs(left.m_elements[pivot][column])) pivot = row;
    const double value = left.m_elements[pivot][column];
    success = value != 0.0 && value == value;
    if (!success) return *this;
    for (int j = 0; j < 4; ++j) {
      const double l = left.m_elements[pivot][j], r = right.m_elements[pivot][j];
      left.m_elements[pivot][j] = left.m_elements[column][j];
      right.m_elements[pivot][j] = right.m_elements[column][j];
      left.m_elements[column][j] = l / value;
      right.m_elements[column][j] = r / value;
    }
    for (int row = 0; row < 4; ++row) {
      const double factor = row == column ? 0.0 : left.m_elements[row][column];
      for (int j = 0; j < 4; ++j) {
        left.m_elements[row][j] -= factor * left.m_elements[column][j];
        right.m_elements[row][j] -= factor * right.m_elements[column][j];
      }
    }
  }
  return right;
}

inline hduMatrix hduMatrix::getInverse() const {
  bool success = false;
  return getInverse(success);
}

inline bool hduMatrix::invert() {
  bool success = false;
  const hduMatrix inverse = getInverse(success);
  if (success) *this = inverse;
  return success;
}

inline double hduMatrix::determinant() const {
  double sum = 0.0;
  for (int j = 0; j < 4; ++j) {
    const int a = j == 0 ? 1 : 0, b = j <= 1 ? 2 : 1, c = j <= 2 ? 3 : 2;
    const double(*m)[4] = m_elements;
    const double minor = m[1][a] * (m[2][b] * m[3][c] - m[2][c] * m[3][b]) - m[1][b] * (m[2][a] * m[3][c] - m[2][c] * m[3][a]) +
                         m[1][c] * (m[2][a] * m[3][b] - m[2][b] * m[3][a]);
    sum += (j % 2 == 0 ? 1.0 : -1.0) * m[0][j] * minor;
  }
  return sum;
}

/* Polar decomposition by Higham's iteration (1986): the mean of a matrix and its inverse transposed tends to its rotation. */
inline void hduMatrix::getRotationMatrix(hduMatrix &rotation) const {
  hduMatrix turn(*this);
  for (int i = 0; i < 3; ++i) turn.m_elements[i][3] = turn.m_elements[3][i] = 0.0;
  turn.m_elements[3][3] = 1.0;
  for (int i = 0; i < 60; ++i) {
    bool success = false;
    const hduMatrix inverse = turn.getInverse(success);
    if (!success) break;
    hduMatrix next(turn);
    (next += inverse.getTranspose()) *= 0.5;
    const bool settled = next.compare(turn, 1e-15);
    turn = next;
    if (settled) break;
  }
  rotation = turn;
}

inline hduMatrix hduMatrix::createTranslation(double x, double y, double z) {
  hduMatrix out;
  out.m_elements[3][0] = x;
  out.m_elements[3][1] = y;
  out.m_elements[3][2] = z;
  return out;
}

inline hduMatrix hduMatrix::createScale(double x, double y, double z) {
  hduMatrix out;
  out.m_elements[0][0] = x;
  out.m_elements[1][1] = y;
  out.m_elements[2][2] = z;
  return out;
}

/* Rodrigues; transposed, for row vectors. An axis of length zero turns nothing. */
inline hduMatrix hduMatrix::createRotation(const hduVector3Dd &axis, double radians) {
  const hduVector3Dd n = ::normalize(axis);
  hduMatrix out;
  if (n.magnitude() == 0.0) return out;
  const double c = cos(radians), s = sin(radians), k = 1.0 - c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.m_elements[i][j] = n[i] * n[j] * k + (i == j ? c : 0.0);
  out.m_elements[0][1] += n[2] * s;
  out.m_elements[0][2] -= n[1] * s;
  out.m_elements[1][2] += n[0] * s;
  out.m_elements[1][0] -= n[2] * s;
  out.m_elements[2][0] += n[1] * s;
  out.m_elements[2][1] -= n[0] * s;
  return out;
}

inline hduMatrix hduMatrix::createRotationTranslation(const hduMatrix &rotation, const hduVector3Dd &translation) {
  hduMatrix out;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) out.m_elements[i][j] = rotation.m_elements[i][j];
    out.m_elements[3][i] = translation[i];
  }
  return out;
}

#endif

#endif
