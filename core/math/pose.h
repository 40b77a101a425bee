/*
 * pose.h - private: what is taken for a rotation. The rest of pose.c is public.
 */
#ifndef SHEEN_POSE_H
#define SHEEN_POSE_H

#include "../sheen.h"

/* 1 where rows' squared lengths and right angles are off by no more than `within`, Q1.30; a mirror counts. */
int sheen_is_rotation(const sheen_q30_t r[9], int32_t within);

/* No rotation given; nothing given at all. */
int sheen_rotation_is_zero(const sheen_q30_t r[9]);
int sheen_pose_is_zero(const struct sheen_pose *pose);

/* 1 where a pose is one, its defaults counted. */
int sheen_pose_valid(const struct sheen_pose *pose);

/* Part i of v where the pose takes it, Q7.24. */
int64_t sheen_pose_part(const struct sheen_pose *pose, int i, const sheen_q24_t v[3]);

/* out = outer * inner, both with their defaults, each entry within 1 raw step of the product; not made orthonormal. */
int sheen_pose_place(const struct sheen_pose *outer, const struct sheen_pose *inner, struct sheen_pose *out);

#endif
