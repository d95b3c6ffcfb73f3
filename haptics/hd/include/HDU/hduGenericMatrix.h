/* Programs include this for the operations on 4x4 matrices; all of them are in hduMatrix. */
#ifndef HALSTED_HDU_GENERIC_MATRIX_H
#define HALSTED_HDU_GENERIC_MATRIX_H

#include <HDU/hduMatrix.h>

#endif
