/*
 * pose.h - private: what is taken for a rotation. The rest of pose.c is public.
 */
#ifndef SHEEN_POSE_H
#define SHEEN_POSE_H

#include "../sheen.h"

/* 1 where rows are of unit length and at right angles, within 1/1024; a mirror counts. */
int sheen_is_rotation(const sheen_q30_t r[9]);

#endif
